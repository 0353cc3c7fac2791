// A reference under seal in the window: put there, opened, and what refuses.
#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/workbench/kit/notes.h"
#include "app/workbench/workbench.h"
#include "core/store/sealed_references.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

const QString kPassphrase = QStringLiteral("correct horse");

class SealFeatureTest : public testing::Test {
 protected:
  void SetUp() override {
    tests::makeStudyFile(path);
    QFile file(curve);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("depth_mm,force_n\n0,0.1\n100,0.4\n200,0.3\n");
    file.close();
    bench.window.show();
    bench.study.open(path);
    ASSERT_TRUE(comesTrue([this] { return bench.study.isOpen() && bench.study.takesOrders(); }));
  }
  QAction* action(const QString& words) {
    for (QAction* const one : bench.window.findChildren<QAction*>()) {
      if (one->text().remove(QLatin1Char('&')).startsWith(words)) return one;
    }
    return nullptr;
  }
  /// The dialog of the feature, as soon as it is there.
  QDialog* asked() {
    QDialog* found = nullptr;
    EXPECT_TRUE(comesTrue([&] {
      for (QDialog* dialog : bench.window.findChildren<QDialog*>()) {
        if (dialog->isVisible() && !secrets(*dialog).isEmpty()) found = dialog;
      }
      return found != nullptr;
    }));
    return found;
  }
  static QList<QLineEdit*> secrets(QDialog& dialog) {
    QList<QLineEdit*> out;
    for (QLineEdit* const field : dialog.findChildren<QLineEdit*>()) {
      if (field->echoMode() == QLineEdit::Password) out << field;
    }
    return out;
  }
  static QPushButton* ok(QDialog& dialog) {
    return dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  }
  void choose(const QString& file) {
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, &answer, [&] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return;
      answer.stop();
      dialog->selectFile(file);
      static_cast<QDialog*>(dialog)->accept();
    });
    answer.start(5);
    action(QStringLiteral("Put a reference curve"))->trigger();
    ASSERT_TRUE(comesTrue([&] { return !answer.isActive(); }));
  }
  void seal() {
    choose(curve);
    QDialog* const dialog = asked();
    ASSERT_NE(dialog, nullptr);
    const auto fields = secrets(*dialog);
    ASSERT_EQ(fields.size(), 2);
    EXPECT_FALSE(ok(*dialog)->isEnabled());
    fields[0]->setText(kPassphrase);
    fields[1]->setText(QStringLiteral("correct house"));
    EXPECT_FALSE(ok(*dialog)->isEnabled()) << "a typing error would lock it for ever";
    fields[1]->setText(kPassphrase);
    ASSERT_TRUE(ok(*dialog)->isEnabled());
    ok(*dialog)->click();
    ASSERT_TRUE(comesTrue([this] { return message().contains(QStringLiteral("under seal")); }))
        << message().toStdString();
  }
  void open(const QString& passphrase) {
    action(QStringLiteral("Open the sealed"))->trigger();
    QDialog* const dialog = asked();
    ASSERT_NE(dialog, nullptr);
    secrets(*dialog)[0]->setText(passphrase);
    ok(*dialog)->click();
  }
  QString message() { return bench.window.banner().message(); }

  tests::ModelFolder folder;
  QString path = folder.path(QStringLiteral("study.tactus"));
  QString curve = folder.path(QStringLiteral("reference.csv"));
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
};

TEST_F(SealFeatureTest, ACurveIsSealedAndOpened) {
  ASSERT_NO_FATAL_FAILURE(seal());
  ASSERT_NO_FATAL_FAILURE(open(QStringLiteral("wrong horse")));
  ASSERT_TRUE(comesTrue([this] { return message().contains(QStringLiteral("was not opened")); }));
  ASSERT_NO_FATAL_FAILURE(open(kPassphrase));
  ASSERT_TRUE(comesTrue([this] { return message().contains(QStringLiteral("The reference is open")); }))
      << message().toStdString();
  bench.study.close();
  ASSERT_TRUE(comesTrue([this] { return !bench.study.isOpen(); }));
  const auto trials = store::sealedTrials(tests::lookInto(path));
  ASSERT_TRUE(trials) << trials.error().message();
  ASSERT_EQ(trials->size(), 1U);
  EXPECT_FALSE(trials->front().reference.late);
  ASSERT_EQ(trials->front().openings.size(), 1U) << "a wrong passphrase is no opening";
  EXPECT_TRUE(trials->front().openings[0].early) << "no model is signed off";
}

TEST_F(SealFeatureTest, ASecondCurveAndOneThatIsNoneAreRefusedWithAWayOut) {
  QFile file(curve);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("depth_mm,force_n\n0,0.1\n");
  file.close();
  choose(curve);
  ASSERT_TRUE(comesTrue([this] { return message().startsWith(QStringLiteral("Nothing was sealed.")); }));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("depth_mm,force_n\n0,0.1\n50,0.2\n");
  file.close();
  ASSERT_NO_FATAL_FAILURE(seal());
  action(QStringLiteral("Put a reference curve"))->trigger();
  ASSERT_TRUE(comesTrue([this] { return message().contains(QStringLiteral("already")); }));
}

}  // namespace
}  // namespace tactus::workbench
