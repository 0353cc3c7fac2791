#include "app/workbench/model/edit_controller.h"

#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/editing/membership_edits.h"

#include "tests/gui/patience.h"
#include "tests/gui/quiet.h"
#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

const editing::TermPlace kHigh{{"force", ""}, "high"};
using tests::kNearShoulder;

class EditControllerTest : public testing::Test {
 protected:
  void SetUp() override { models.open(folder.write(tests::twoExperts())); }

  const fuzzy::ForceModel& shown() const { return models.current()->model; }

  tests::ModelFolder folder;
  ModelController models;
  EditController edits{models};
};

TEST_F(EditControllerTest, AnEditReachesTheOpenModelAndUndoTakesItBack) {
  const fuzzy::ForceModel before = shown();
  ASSERT_TRUE(edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 3)));
  EXPECT_EQ(shown().inputs[1].terms[0].points, (std::vector<double>{0, 0, 3, 5}));
  EXPECT_TRUE(models.isModified());
  const fuzzy::ForceModel after = shown();

  EXPECT_TRUE(edits.undoText().contains(QStringLiteral("Near"))) << edits.undoText().toStdString();
  edits.undo();
  EXPECT_EQ(shown(), before);
  EXPECT_FALSE(models.isModified());
  EXPECT_FALSE(edits.canUndo());
  edits.redo();
  EXPECT_EQ(shown(), after);
  EXPECT_FALSE(edits.canRedo());
}

TEST_F(EditControllerTest, AGestureIsOneEntry) {
  edits.begin();
  for (const double to : {3.5, 3.0, 2.0}) edits.update(editing::moveVertex(edits.base(), kNearShoulder, to));
  edits.commit();
  EXPECT_EQ(shown().inputs[1].terms[0].points[2], 2);
  EXPECT_EQ(edits.history().line().size(), 2U);
  edits.undo();
  EXPECT_EQ(shown(), tests::twoExperts());
}

TEST_F(EditControllerTest, ACanceledGestureLeavesNothing) {
  edits.begin();
  edits.update(editing::moveVertex(edits.base(), kNearShoulder, 2));
  EXPECT_EQ(edits.model().inputs[1].terms[0].points[2], 2);
  edits.cancel();
  EXPECT_EQ(shown(), tests::twoExperts());
  EXPECT_FALSE(edits.canUndo());
}

TEST_F(EditControllerTest, AGestureWithoutAChangeIsNoEntry) {
  edits.begin();
  edits.update(editing::moveVertex(edits.base(), kNearShoulder, 2));
  edits.update(editing::moveVertex(edits.base(), kNearShoulder, 4));
  edits.commit();
  EXPECT_FALSE(edits.canUndo());
  EXPECT_EQ(shown(), tests::twoExperts());
}

TEST_F(EditControllerTest, AFastHandSendsOneModelForEachRefresh) {
  const QSignalSpy edited(&models, &ModelController::edited);
  edits.begin();
  constexpr int kMoves = 200;
  for (int i = 0; i < kMoves; ++i) edits.update(editing::moveVertex(edits.base(), kNearShoulder, 4 - i * 0.01));
  // The first goes at once, the others wait for the end of the frame, which needs the event loop.
  EXPECT_EQ(edited.count(), 1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return tests::isQuiet(edits); }, tests::kPatience));
  EXPECT_EQ(edited.count(), 2);
  EXPECT_EQ(shown().inputs[1].terms[0].points[2], 4 - (kMoves - 1) * 0.01);
  edits.commit();
}

TEST_F(EditControllerTest, ReportsTheLargestChangeOfTheForce) {
  QSignalSpy reported(&edits, &EditController::reported);
  // The rectangle [0.5, 1] N with the centroid 0.75 N becomes [0.6, 1] with 0.8 N: 0.05 N where only expert A has a
  // force. Noticeable there is sqrt(0.04^2 + (0.12 * 0.75)^2) = 0.0985 N, so the change is half of it.
  ASSERT_TRUE(edits.apply(editing::moveEdge(edits.model(), kHigh, editing::Side::kLeft, 0.1)));
  ASSERT_TRUE(reported.wait(1000));
  const QString sentence = reported[0][0].toString();
  EXPECT_TRUE(sentence.contains(QStringLiteral("max ΔF anywhere at least 0.050 N (0.5 JND)")))
      << sentence.toStdString();
  EXPECT_TRUE(sentence.contains(QStringLiteral("High"))) << sentence.toStdString();
}

TEST_F(EditControllerTest, AnImpossibleEditIsRefusedWithASentence) {
  const QSignalSpy refused(&edits, &EditController::refused);
  EXPECT_FALSE(edits.apply(editing::moveVertex(edits.model(), {{"depth", ""}, "nowhere", 0}, 1)));
  ASSERT_EQ(refused.count(), 1);
  EXPECT_TRUE(refused[0][0].toString().contains(QStringLiteral("nowhere")));
  EXPECT_EQ(shown(), tests::twoExperts());
}

TEST_F(EditControllerTest, AnyEntryCanBeReturnedTo) {
  edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 3));
  edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 2));
  edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 1));
  const auto states = edits.history().line();
  ASSERT_EQ(states.size(), 4U);
  EXPECT_EQ(states[3], edits.history().current());
  edits.returnTo(states[1]);
  EXPECT_EQ(shown().inputs[1].terms[0].points[2], 3);
  edits.returnTo(states[0]);
  EXPECT_EQ(shown(), tests::twoExperts());
}

TEST_F(EditControllerTest, AnotherModelBeginsAnotherHistory) {
  edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 3));
  models.reopen();
  EXPECT_FALSE(edits.canUndo());
  EXPECT_EQ(edits.model(), tests::twoExperts());
}

TEST_F(EditControllerTest, StampsSayWhoEdits) {
  edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 3));
  edits.setAuthor(QStringLiteral(" M. Ortiz "));
  edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 2));
  const auto& events = edits.history().events();
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[1].stamp.author, "unnamed");
  EXPECT_EQ(events[2].stamp.author, "M. Ortiz");
}

TEST_F(EditControllerTest, GoesOnWithAHistoryThatWasStored) {
  edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 3));
  edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 2));
  const auto versions = editing::unstoredVersions(edits.history());
  ASSERT_EQ(versions.size(), 3U);
  for (const auto& version : versions) edits.markStored(version.id);
  EXPECT_TRUE(editing::unstoredVersions(edits.history()).empty());

  models.reopen();
  EXPECT_EQ(shown(), tests::twoExperts());
  const QSignalSpy reset(&edits, &EditController::modelReset);
  auto history = editing::historyFrom(versions, study::RecordIds(5));
  ASSERT_TRUE(history.has_value());
  edits.adopt(std::move(*history), [&](const study::RecordId& id) -> base::Result<study::ModelVersion> {
    return *std::find_if(versions.begin(), versions.end(), [&](const auto& version) { return version.id == id; });
  });
  EXPECT_EQ(reset.count(), 1);
  EXPECT_EQ(shown().inputs[1].terms[0].points[2], 2);
  EXPECT_TRUE(models.isModified());
  edits.undo();
  edits.undo();
  EXPECT_EQ(shown(), tests::twoExperts());
  EXPECT_FALSE(edits.canUndo());
}

}  // namespace
}  // namespace tactus::workbench
