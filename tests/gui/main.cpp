// Runs the tests of the workbench without a display. Any warning that Qt logs ends the run.
#include <QApplication>
#include <QLocale>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/workbench/base/theme.h"
#include "app/workbench/base/utf8_locale.h"
#include "app/workbench/program_options.h"

#include "tests/gui/stop_on_warning.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const QTemporaryDir runtime_folder;
  qputenv("XDG_RUNTIME_DIR", runtime_folder.path().toUtf8());
  qputenv("XDG_DATA_HOME", runtime_folder.path().toUtf8());
  qputenv("QT_QPA_PLATFORM", "offscreen");
  tactus::tests::stopOnWarnings();
  tactus::workbench::useUtf8Locale();
  QApplication application(argc, argv);
  tactus::workbench::theme::apply(application);
  tactus::workbench::installTranslations(application, QLocale(QLocale::English));
  return RUN_ALL_TESTS();
}
