#include "app/editing/edit_history.h"

#include <gtest/gtest.h>

#include "app/editing/edit.h"
#include "app/editing/rule_edits.h"
#include "app/editing/term_edits.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

const Stamp kAnn{"Ann", 1000};

EditHistory historyOf(const fuzzy::ForceModel& model) {
  return EditHistory::open(model, "S4 as printed", kAnn, study::RecordIds(1)).value();
}

/// The right foot of the nasopharynx at `to` mm.
Edit foot(const fuzzy::ForceModel& model, double to) { return must(moveVertex(model, {kDepth, "nasopharynx", 3}, to)); }

double footOf(const EditHistory& history) { return pointsOf(history.model(), "depth", "nasopharynx")[3]; }

class EditHistoryTest : public testing::Test {
 protected:
  const fuzzy::ForceModel model_ = support::s4AsPrinted();
  EditHistory history_ = historyOf(model_);
};

TEST_F(EditHistoryTest, ADragIsOneEntry) {
  history_.begin();
  for (const double to : {126.0, 129.0, 200.0, 132.0}) {
    history_.update(foot(history_.base(), to));
    EXPECT_EQ(footOf(history_), to);
  }
  EXPECT_EQ(history_.states().size(), 1);
  const auto state = history_.commit(kAnn);
  ASSERT_EQ(state, 1);
  EXPECT_EQ(history_.labelOf(1), "Depth / nasopharynx: right foot 125 to 132 mm");
  ASSERT_TRUE(history_.undo(kAnn));
  EXPECT_TRUE(sameBits(history_.model(), model_));
  ASSERT_TRUE(history_.redo(kAnn));
  EXPECT_EQ(footOf(history_), 132);
  EXPECT_FALSE(history_.redo(kAnn));
}

TEST_F(EditHistoryTest, ADragThatIsDroppedOrChangesNothingIsNone) {
  history_.update(foot(history_.base(), 140));
  history_.cancel();
  EXPECT_EQ(footOf(history_), 125);
  history_.begin();
  history_.update(foot(history_.base(), 140));
  history_.update(foot(history_.base(), 125));
  EXPECT_FALSE(history_.commit(kAnn));
  history_.begin();
  EXPECT_FALSE(history_.commit(kAnn));
  EXPECT_FALSE(history_.canUndo());
  EXPECT_FALSE(history_.undo(kAnn));
  EXPECT_EQ(history_.events().size(), 1);
}

TEST_F(EditHistoryTest, UndoEndsAGestureThatGoesOn) {
  history_.update(foot(history_.base(), 140));
  ASSERT_TRUE(history_.undo(kAnn));
  EXPECT_EQ(footOf(history_), 125);
  ASSERT_TRUE(history_.redo(kAnn));
  EXPECT_EQ(footOf(history_), 140);
}

TEST_F(EditHistoryTest, ABranchIsNeverLost) {
  history_.apply(foot(history_.model(), 130), kAnn);
  history_.apply(foot(history_.model(), 131), kAnn);
  ASSERT_TRUE(history_.undo(kAnn));
  history_.apply(foot(history_.model(), 140), kAnn);
  EXPECT_EQ(history_.line(), (std::vector<StateId>{0, 1, 3}));
  EXPECT_FALSE(history_.canRedo());
  ASSERT_TRUE(history_.returnTo(2, kAnn));
  EXPECT_EQ(footOf(history_), 131);
  EXPECT_EQ(history_.line(), (std::vector<StateId>{0, 1, 2}));
  ASSERT_TRUE(history_.undo(kAnn));
  ASSERT_TRUE(history_.redo(kAnn));
  EXPECT_EQ(history_.current(), 2);
  EXPECT_FALSE(history_.returnTo(17, kAnn));
}

TEST_F(EditHistoryTest, ChecksFollowAnEditAndComeBackWithUndo) {
  auto model = model_;
  model.checks = {{{1, 45, 30, 30}, 0.12666666666666668, true}, {{1, 60, 50, 130}, 0, false}};
  auto history = historyOf(model);
  // At 130 mm no rule fired; 5 mm into the stretched foot of 25 mm one does.
  history.apply(foot(history.model(), 150), kAnn);
  EXPECT_TRUE(history.model().checks[1].fired);
  EXPECT_EQ(history.model().checks[1].force, history.compiled().evaluate(model.checks[1].in).force_n);
  ASSERT_TRUE(history.undo(kAnn));
  EXPECT_TRUE(sameBits(history.model(), model));
}

TEST_F(EditHistoryTest, ASignOffSaysHowTheStateWasFelt) {
  history_.signOff({"S4", 5000}, {4, "Touch", false, {"Nasal cavity", "Nasopharynx", "Oropharynx"}});
  EXPECT_EQ(history_.events().back().label,
            "feels right, after 0 edits: 4 strokes on Touch, Nasal cavity to Oropharynx");
  EXPECT_TRUE(saysFelt(history_.events().back().label));
  history_.signOff({"S4", 6000}, {1, "Virtual device", true, {}});
  EXPECT_EQ(history_.events().back().label, "feels right, after 0 edits: 1 stroke on Virtual device (simulated)");
}

TEST_F(EditHistoryTest, SnapshotsAndSignOffTellOfTheState) {
  history_.apply(foot(history_.model(), 130), kAnn);
  history_.snapshot("before lunch", kAnn);
  history_.apply(foot(history_.model(), 131), kAnn);
  history_.apply(foot(history_.model(), 132), kAnn);
  history_.signOff({"S4", 5000});
  const auto& events = history_.events();
  ASSERT_EQ(events.size(), 6);
  EXPECT_EQ(events[2].kind, EventKind::kSnapshot);
  EXPECT_EQ(events[2].state, 1);
  EXPECT_EQ(events[2].label, "before lunch");
  EXPECT_EQ(events[5].label, "approved without feeling, after 3 edits");
  EXPECT_FALSE(saysFelt(events[5].label));
  EXPECT_EQ(events[5].stamp, (Stamp{"S4", 5000}));
  EXPECT_EQ(events[5].state, 3);
}

TEST_F(EditHistoryTest, NewtonsOfAnEntryAndOfAnyTwo) {
  history_.apply(must(setConsequent(history_.model(), "S4", 3, "large")), kAnn);
  history_.apply(must(setConsequent(history_.model(), "S4", 3, "medium")), kAnn);
  const auto impact = history_.impact(1);
  ASSERT_TRUE(impact);
  EXPECT_GT(impact->largest_n, 0.05);
  EXPECT_FALSE(history_.impact(0));
  EXPECT_FALSE(history_.impact(9));
  EXPECT_EQ(history_.compare(0, 1)->largest_n, impact->largest_n);
  EXPECT_EQ(history_.compare(0, 2)->largest_n, 0);
  EXPECT_FALSE(history_.compare(0, 9));
}

TEST_F(EditHistoryTest, UndoGoesBackOverEveryKindOfEdit) {
  std::vector<fuzzy::ForceModel> states = {model_};
  const auto apply = [&](Edit edit) {
    ASSERT_TRUE(history_.apply(std::move(edit), kAnn));
    states.push_back(history_.model());
  };
  SplitOptions thirds;
  thirds.cuts = {290, 365};
  apply(must(splitTerm(history_.model(), {kDepth, "esophagus"}, thirds)));
  apply(must(makeOwn(history_.model(), {"speed", "S4"})));
  apply(must(renameTerm(history_.model(), {kDepth, "esophagus_2"}, "middle", "Middle")));
  apply(must(removeTerm(history_.model(), {kDepth, "middle"}, {RulesOfTerm::kRemove, true})));
  apply(must(setExpertWeight(history_.model(), "S4", 0.1)));
  for (std::size_t s = states.size() - 1; s-- > 0;) {
    ASSERT_TRUE(history_.undo(kAnn));
    EXPECT_TRUE(sameBits(history_.model(), states[s])) << s;
  }
  for (std::size_t s = 1; s < states.size(); ++s) {
    ASSERT_TRUE(history_.redo(kAnn));
    EXPECT_TRUE(sameBits(history_.model(), states[s])) << s;
  }
}

TEST_F(EditHistoryTest, StoredStatesLeaveTheMemory) {
  for (int k = 0; k < 50; ++k) history_.apply(must(setExpertWeight(history_.model(), "S4", 2 + k)), kAnn);
  const std::size_t all = history_.trim(std::size_t{1} << 40U);
  EXPECT_EQ(history_.trim(0), all);  // nothing is stored yet
  for (const auto& event : std::vector(history_.events())) history_.markStored(event.id);
  history_.snapshot("last", kAnn);
  EXPECT_LT(history_.trim(all / 10), all / 5);
  ASSERT_TRUE(history_.missing(3));
  EXPECT_FALSE(history_.returnTo(3, kAnn));
  EXPECT_FALSE(history_.missing(50));
  auto wanted = model_;
  wanted.experts[0].weight = 4;  // of state 3
  EXPECT_FALSE(history_.provide(4, *history_.missing(3), wanted));
  ASSERT_TRUE(history_.provide(3, *history_.missing(3), wanted));
  ASSERT_TRUE(history_.returnTo(3, kAnn));
  EXPECT_TRUE(sameBits(history_.model(), wanted));
}

TEST_F(EditHistoryTest, TheCurrentModelAndTheOneBeforeAreSharedNotMadeAgain) {
  const SharedModel opened = history_.ready();
  EXPECT_EQ(history_.readyOf(0).value(), opened);
  history_.apply(foot(history_.model(), 130), kAnn);
  const SharedModel edited = history_.ready();
  EXPECT_NE(edited, opened);
  EXPECT_EQ(history_.readyOf(0).value(), opened);
  ASSERT_TRUE(history_.undo(kAnn));
  EXPECT_EQ(history_.ready(), opened);
  ASSERT_TRUE(history_.redo(kAnn));
  EXPECT_EQ(history_.ready(), edited);
  EXPECT_FALSE(history_.readyOf(9));
}

TEST(SameBits, TellsTheTwoZerosApart) {
  auto one = support::s4AsPrinted();
  auto other = one;
  EXPECT_TRUE(sameBits(one, other));
  other.inputs[0].terms[0].points[0] = -0.0;
  EXPECT_EQ(one, other);
  EXPECT_FALSE(sameBits(one, other));
}

}  // namespace
}  // namespace tactus::editing
