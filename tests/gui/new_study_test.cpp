// A new study asks what it is about.
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QFileDialog>
#include <QLabel>
#include <QSettings>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/workbench/features/features.h"
#include "app/workbench/workbench.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class NewStudy : public testing::Test {
 protected:
  /// The dialog that asks for the procedure.
  QComboBox* asked() {
    bench.study_feature->chooseNew();
    for (QDialog* dialog : bench.window.findChildren<QDialog*>()) {
      if (dialog->isVisible() && dialog->findChild<QComboBox*>() != nullptr) return dialog->findChild<QComboBox*>();
    }
    return nullptr;
  }
  /// Accepts the question; then answers the file dialog with `path`.
  void accept(QComboBox& which, const QString& path) {
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, &answer, [&] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return;
      answer.stop();
      dialog->selectFile(path);
      static_cast<QDialog*>(dialog)->accept();
    });
    answer.start(5);
    qobject_cast<QDialog*>(which.window())->accept();
  }

  tests::ModelFolder folder;
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
};

TEST_F(NewStudy, OffersTheProceduresByTheirTitles) {
  bench.window.show();
  QComboBox* which = asked();
  ASSERT_NE(which, nullptr);
  EXPECT_EQ(which->count(), static_cast<int>(procedure::builtInIds().size()) + 1);
  EXPECT_EQ(which->itemText(0), QStringLiteral("Nasogastric tube insertion"));
  EXPECT_EQ(which->itemText(which->count() - 1), QStringLiteral("From a folder…"));
}

TEST_F(NewStudy, KeepsWhatWasChosenAndSaysItInTheTitle) {
  bench.window.show();
  QComboBox* which = asked();
  ASSERT_NE(which, nullptr);
  which->setCurrentIndex(which->findText(QStringLiteral("Male urethral catheter insertion")));
  const QString path = folder.path(QStringLiteral("catheter.tactus"));
  accept(*which, path);
  ASSERT_TRUE(comesTrue([&] { return bench.study.path() == path; }));
  EXPECT_EQ(bench.study.procedure()->id, "male-urethral-catheter");
  EXPECT_TRUE(bench.window.windowTitle().contains(QStringLiteral("catheter.tactus (Male urethral catheter insertion)")))
      << bench.window.windowTitle().toStdString();
}

}  // namespace
}  // namespace tactus::workbench
