// Runs the tests of the workbench without a display. Any warning that Qt logs ends the run.
#include <QApplication>
#include <QTemporaryDir>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>

#include "app/workbench/theme.h"

namespace {

// The offscreen platform says this of every window with a size limit.
constexpr auto kExpected = "This plugin does not support propagateSizeHints()";

void stopOnWarning(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
  if (message == QLatin1String(kExpected)) return;
  std::fprintf(stderr, "Qt: %s\n", qPrintable(message));
  if (type != QtDebugMsg && type != QtInfoMsg) std::abort();
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const QTemporaryDir runtime_folder;
  qputenv("XDG_RUNTIME_DIR", runtime_folder.path().toUtf8());
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qInstallMessageHandler(stopOnWarning);
  QApplication application(argc, argv);
  tactus::workbench::theme::apply(application);
  return RUN_ALL_TESTS();
}
