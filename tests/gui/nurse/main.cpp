// Runs the tests of the nurse's screens without a display, in one screen of the size of a small laptop; with the
// display of the platform TACTUS_TEST_PLATFORM where that is set. Any warning that Qt logs ends the run.
#include <QApplication>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/workbench/base/theme.h"
#include "app/workbench/base/utf8_locale.h"

#include "tests/gui/stop_on_warning.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const QTemporaryDir runtime_folder;
  qputenv("XDG_RUNTIME_DIR", runtime_folder.path().toUtf8());
  const QByteArray platform = qgetenv("TACTUS_TEST_PLATFORM");
  qputenv("QT_QPA_PLATFORM", platform.isEmpty() ? "offscreen" : platform);
  tactus::tests::stopOnWarnings();
  tactus::workbench::useUtf8Locale();
  QApplication application(argc, argv);
  QApplication::setCursorFlashTime(0);
  tactus::workbench::theme::apply(application);
  return RUN_ALL_TESTS();
}
