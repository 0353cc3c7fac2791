// An error says what did not happen, and offers the way out as a button that leads there.
#include <QAbstractButton>
#include <QSettings>
#include <gtest/gtest.h>

#include "app/workbench/collect/collect_view.h"
#include "app/workbench/collect/protocol_view.h"
#include "app/workbench/collect/withdrawal_dialog.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/workbench.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class ErrorActs : public testing::Test {
 protected:
  void SetUp() override {
    bench.window.resize(1280, 720);
    bench.window.show();
    const QString path = folder.path(QStringLiteral("ward-7.tactus"));
    tests::makeStudyFile(
        path, [](store::StudyFile& file, study::RecordIds& ids) { tests::addVisit(file, ids, "amber-crow", true); });
    bench.study.open(path);
    ASSERT_TRUE(comesTrue([this] { return collect().isCurrent() && bench.protocol.isReady(); }));
    bench.window.banner().hide();
  }

  CollectController& collect() { return bench.collect; }
  ProtocolController& protocol() { return bench.protocol; }
  CollectView& view() { return *bench.views.collect; }
  /// The error on the screen begins with `what`; its button `act` is pressed.
  void expectError(const QString& what, const QString& act) {
    ASSERT_TRUE(comesTrue([this] { return bench.window.banner().isVisible(); }));
    EXPECT_TRUE(bench.window.banner().message().startsWith(what)) << bench.window.banner().message().toStdString();
    for (auto* button : bench.window.banner().findChildren<QAbstractButton*>()) {
      if (button->isVisible() && button->text() == act) return button->click();
    }
    FAIL() << "no button " << act.toStdString();
  }

  tests::ModelFolder folder;
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
};

TEST_F(ErrorActs, AKeyThatIsRefusedIsEnteredAgain) {
  protocol().setKey(QStringLiteral("abc"));  // too short
  expectError(QStringLiteral("The research key stays as it was. "), QStringLiteral("Enter the key again"));
  EXPECT_TRUE(view().protocolPage().isVisible());
  EXPECT_FALSE(bench.window.banner().isVisible());
}

TEST_F(ErrorActs, AProtocolThatIsRefusedIsEdited) {
  bench.models.open(folder.write(tests::twoExperts()));
  bench.window.enter(Stage::kTune);
  emit protocol().refused(QStringLiteral("The protocol stays as it was. No reason."));
  expectError(QStringLiteral("The protocol stays as it was. "), QStringLiteral("Edit the protocol"));
  EXPECT_EQ(bench.window.stage(), Stage::kCollect);
  EXPECT_TRUE(view().protocolPage().isVisible());
}

TEST_F(ErrorActs, AWithdrawalThatFailedIsAskedForAgain) {
  emit collect().withdrawalRefused(collect().overview().rows.at(0).person,
                                   QStringLiteral("amber-crow was not withdrawn. The disk is full."));
  expectError(QStringLiteral("amber-crow was not withdrawn. "), QStringLiteral("Withdraw again…"));
  auto* dialog = view().findChild<WithdrawalDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->isVisible());
  ASSERT_TRUE(comesTrue([dialog] { return dialog->isCounted(); }));
  dialog->reject();
}

TEST_F(ErrorActs, AModelThatIsNotBuiltLeadsToTheStudy) {
  bench.models.open(folder.write(tests::twoExperts()));
  bench.window.enter(Stage::kTune);
  bench.window.banner().hide();
  bench.study_models.buildModel();  // of a participant without answers
  expectError(QStringLiteral("No model was built. "), QStringLiteral("Look at the study"));
  EXPECT_EQ(bench.window.stage(), Stage::kCollect);
}

TEST_F(ErrorActs, ACorrectionThatWasNotStoredIsTriedAgain) {
  bool again = false;
  emit bench.labs.corrections.refused(QStringLiteral("Not stored: marks of stroke 2. The disk is full."),
                                      {QStringLiteral("Try again"), [&again] { again = true; }});
  expectError(QStringLiteral("Not stored: marks of stroke 2. "), QStringLiteral("Try again"));
  EXPECT_TRUE(again);
}

}  // namespace
}  // namespace tactus::workbench
