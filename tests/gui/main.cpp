// Runs the tests of the workbench without a display. Any warning that Qt logs ends the run.
#include <QApplication>
#include <QLocale>
#include <QTemporaryDir>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>

#include "app/workbench/base/theme.h"
#include "app/workbench/translation.h"

namespace {

// The offscreen platform says this of every window with a size limit, and of every popup.
constexpr const char* kExpected[] = {"This plugin does not support propagateSizeHints()",
                                     "This plugin does not support raise()",
                                     "This plugin does not support grabbing the keyboard"};

void stopOnWarning(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
  for (const char* expected : kExpected) {
    if (message == QLatin1String(expected)) return;
  }
  std::fprintf(stderr, "Qt: %s\n", qPrintable(message));
  if (type != QtDebugMsg && type != QtInfoMsg) std::abort();
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const QTemporaryDir runtime_folder;
  qputenv("XDG_RUNTIME_DIR", runtime_folder.path().toUtf8());
  qputenv("XDG_DATA_HOME", runtime_folder.path().toUtf8());
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qInstallMessageHandler(stopOnWarning);
  QApplication application(argc, argv);
  tactus::workbench::theme::apply(application);
  tactus::workbench::installTranslations(application, QLocale(QLocale::English));
  return RUN_ALL_TESTS();
}
