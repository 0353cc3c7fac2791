#include "app/workbench/tune/strokes/strokes_controller.h"

#include <QSignalSpy>
#include <cmath>

#include "tests/gui/tune/strokes/strokes_fixture.h"

namespace tactus::workbench {
namespace {

using State = StrokesController::State;
using tests::comesTrue;

class StrokesControllerTest : public StrokesFixture {};

TEST_F(StrokesControllerTest, WhatTheServoRecordedComesOutAgainBitForBit) {
  openStudy();
  record();
  strokes.setSeen(true);
  ASSERT_TRUE(isShown());
  ASSERT_EQ(strokes.comparison().strokes.size(), 2U);
  EXPECT_TRUE(strokes.leftOut().isEmpty()) << strokes.leftOut().join(' ').toStdString();
  for (const replay::RecordedStroke& stroke : *strokes.baseline().strokes) {
    EXPECT_EQ(stroke.use, replay::StrokeUse::kExact);
    EXPECT_TRUE(stroke.simulated);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& run = *strokes.baseline().runs[i];
    EXPECT_EQ(run.force_n, (*strokes.baseline().strokes)[i].recorded_n);
    EXPECT_GT(*std::max_element(run.force_n.begin(), run.force_n.end()), .05);
  }
  EXPECT_EQ(strokes.headline(), QStringLiteral("2 strokes, and no force changes."));
  EXPECT_TRUE(strokes.caption().contains(QStringLiteral("No edit yet"))) << strokes.caption().toStdString();
  EXPECT_TRUE(strokes.caption().contains(QStringLiteral("SIMULATED")));
}

TEST_F(StrokesControllerTest, AnEditIsComparedWithTheModelBeforeIt) {
  openStudy();
  record();
  strokes.setSeen(true);
  ASSERT_TRUE(isShown());
  harden();
  ASSERT_TRUE(comesTrue([this] { return strokes.comparison().summary.felt == 2; }));
  // Low to High: expert A alone asks for three times the force, in the mean with B where B says nothing too.
  const auto& worst = *strokes.comparison().strokes[0].numbers;
  EXPECT_GT(worst.noticeable, 1);
  EXPECT_GT(worst.noticeable_by_n, 0);
  EXPECT_TRUE(
      strokes.headline().startsWith(QStringLiteral("Of 2 strokes, 2 would feel different: recording 1, stroke ")))
      << strokes.headline().toStdString();
  EXPECT_TRUE(strokes.caption().contains(QStringLiteral("Compared with: Before the last edit")))
      << strokes.caption().toStdString();
  edits.undo();
  ASSERT_TRUE(comesTrue([this] { return strokes.comparison().summary.felt == 0; }));
}

TEST_F(StrokesControllerTest, TheLastSignOffStaysTheModelBefore) {
  openStudy();
  record();
  EXPECT_FALSE(strokes.isSignedOff());
  strokes.setAgainst(StrokesController::Against::kSignOff);
  EXPECT_EQ(strokes.against(), StrokesController::Against::kGhost) << "nothing is signed off";
  edits.signOff(QStringLiteral("S4"));
  ASSERT_TRUE(strokes.isSignedOff());
  harden();
  fuzzy::ForceModel named = edits.model();
  named.name += " again";
  ASSERT_TRUE(edits.apply(editing::finished(named, "Another name")));
  strokes.setSeen(true);
  ASSERT_TRUE(isShown());
  ASSERT_TRUE(comesTrue([this] { return !strokes.isOld() && strokes.comparison().summary.felt == 2; }));
  EXPECT_TRUE(strokes.caption().contains(QStringLiteral("Compared with: the sign-off of S4, ")))
      << strokes.caption().toStdString();
  ghost.setOn(false);
  EXPECT_EQ(strokes.state(), State::kShown) << "the curves' model before does not matter";
  ghost.setOn(true);
  strokes.setAgainst(StrokesController::Against::kGhost);
  ASSERT_TRUE(comesTrue([this] { return !strokes.isOld() && strokes.comparison().summary.felt == 0; }));
}

TEST_F(StrokesControllerTest, NothingRunsWhileNobodyLooks) {
  openStudy();
  record();
  harden();
  EXPECT_EQ(strokes.state(), State::kWaiting);
  QSignalSpy changed(&strokes, &StrokesController::changed);
  EXPECT_FALSE(strokes.isOld());
  strokes.setSeen(true);
  ASSERT_TRUE(isShown());
  strokes.setSeen(false);
  const double before = strokes.comparison().strokes[0].numbers->noticeable;
  edits.undo();
  EXPECT_FALSE(strokes.isOld()) << "no computation has begun";
  EXPECT_EQ(strokes.comparison().strokes[0].numbers->noticeable, before);
}

TEST_F(StrokesControllerTest, AStrokeLeadsToThePlaceOfItsLargestDifference) {
  openStudy();
  record();
  strokes.setSeen(true);
  ASSERT_TRUE(isShown());
  harden();
  ASSERT_TRUE(comesTrue([this] { return strokes.comparison().summary.felt == 2; }));
  strokes.goTo(0);
  EXPECT_EQ(strokes.chosen(), 0U);
  EXPECT_EQ(scene.value(tests::kDepth), strokes.comparison().strokes[0].numbers->largest_at_mm);
  ASSERT_TRUE(strokes.chosenRecording());
  QSignalSpy asked(&strokes, &StrokesController::replayRequested);
  strokes.replayChosen();
  ASSERT_EQ(asked.count(), 1);
  EXPECT_EQ(asked[0][0].value<study::RecordId>(), study.recordings()[0].start.entry.id);
  EXPECT_TRUE(strokes.numbersOf(0).contains(QStringLiteral("peak ")));
}

TEST_F(StrokesControllerTest, AHoleIsNamed) {
  openStudy();
  record();
  strokes.setSeen(true);
  ASSERT_TRUE(isShown());
  fuzzy::ForceModel open = edits.model();
  open.experts[0].rules[0].enabled = open.experts[0].rules[1].enabled = false;  // near: nothing
  ASSERT_TRUE(edits.apply(editing::finished(open, "Near: off")));
  ASSERT_TRUE(comesTrue([this] { return strokes.comparison().summary.holes == 2; }));
  EXPECT_EQ(strokes.headline(), QStringLiteral("2 strokes would meet a place where no rule fires."));
  EXPECT_TRUE(strokes.verdictOf(0).startsWith(QStringLiteral("no rule fires at ")));
  strokes.goTo(0);
  EXPECT_GE(scene.value(tests::kDepth), 0);
}

TEST_F(StrokesControllerTest, EachEmptyStateSaysWhatIsMissing) {
  strokes.setSeen(true);
  EXPECT_EQ(strokes.state(), State::kNoStudy);
  EXPECT_TRUE(strokes.mayRecord());
  openStudy();
  ASSERT_TRUE(comesTrue([this] { return strokes.state() == State::kNoStroke; }));
  record();
  ASSERT_TRUE(isShown());
  ghost.setOn(false);
  EXPECT_EQ(strokes.state(), State::kGhostOff);
  strokes.showGhost();
  EXPECT_TRUE(ghost.isOn());
  EXPECT_TRUE(isShown());
  study.close();
  ASSERT_TRUE(comesTrue([this] { return strokes.state() == State::kNoStudy; }));
}

TEST_F(StrokesControllerTest, AModelFromOutsideTheStudyIsNotUsedForAVerdict) {
  openStudy();
  models.open(folder.write(tests::twoExperts(), QStringLiteral("outside.tactus.json")));
  record();
  strokes.setSeen(true);
  ASSERT_TRUE(comesTrue([this] { return strokes.state() == State::kNothing; }));
  ASSERT_EQ(strokes.leftOut().size(), 1);
  EXPECT_EQ(strokes.leftOut()[0], QStringLiteral("2 strokes left out: felt on a model that the study does not keep."));
}

}  // namespace
}  // namespace tactus::workbench
