#include <gtest/gtest.h>

#include "app/editing/edit.h"
#include "app/editing/history_versions.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

const Stamp kEarlierAnn{"Ann", 1000};
const Stamp kBen{"Ben", 9000};

/// The history of a model file: opened, the foot of the nasopharynx moved to 130, then to 131.
class EarlierHistoryTest : public testing::Test {
 protected:
  EarlierHistoryTest() {
    move(130);
    move(131);
  }
  void move(double to) { history_.apply(foot(to), kEarlierAnn); }
  Edit foot(double to) const { return must(moveVertex(history_.base(), {kDepth, "nasopharynx", 3}, to)); }
  static EditHistory opened(const fuzzy::ForceModel& model) {
    return EditHistory::open(model, "Opened", kBen, study::RecordIds(7)).value();
  }
  KeptVersions kept() const { return {unstoredVersions(history_), {}}; }
  base::Result<EarlierHistory> reopened(const fuzzy::ForceModel& file) const {
    return goOn(kept(), opened(file), study::RecordIds(8), "changed", kBen);
  }

  EditHistory history_ = EditHistory::open(support::s4AsPrinted(), "S4", kEarlierAnn, study::RecordIds(1)).value();
};

TEST_F(EarlierHistoryTest, GoesOnWithTheLastState) {
  auto earlier = reopened(history_.model());
  ASSERT_TRUE(earlier) << earlier.error().message();
  EXPECT_FALSE(earlier->lost);
  EXPECT_FALSE(earlier->changed_elsewhere);
  EXPECT_EQ(earlier->kept, 3U);
  EXPECT_TRUE(sameBits(earlier->history.model(), history_.model()));
  EXPECT_EQ(unstoredVersions(earlier->history), unstoredVersions(history_)) << "the same events, all still in memory";
  ASSERT_TRUE(earlier->history.undo(kBen));
  ASSERT_TRUE(earlier->history.undo(kBen));
  EXPECT_TRUE(sameBits(earlier->history.model(), support::s4AsPrinted()));
}

TEST_F(EarlierHistoryTest, AFileWithAnOlderStateIsShownAndTheNewestOffered) {
  const auto earlier = reopened(history_.modelOf(1).value());
  ASSERT_TRUE(earlier);
  EXPECT_EQ(earlier->history.current(), 1U);
  EXPECT_EQ(earlier->lost, 2U);
  EXPECT_EQ(earlier->edits, 1U);
  EXPECT_EQ(earlier->last_utc_ms, 1000);
  EXPECT_FALSE(earlier->changed_elsewhere);
  // The way back is an event that counts as soon as another one follows.
  EXPECT_EQ(earlier->history.events().back().kind, EventKind::kReturn);
  EXPECT_EQ(earlier->kept, 4U);
}

TEST_F(EarlierHistoryTest, AModelOfAnotherProgramBecomesAnEditOfTheLastState) {
  const fuzzy::ForceModel theirs = foot(140).model;
  auto earlier = reopened(theirs);
  ASSERT_TRUE(earlier);
  EXPECT_TRUE(earlier->changed_elsewhere);
  EXPECT_FALSE(earlier->lost);
  EXPECT_TRUE(sameBits(earlier->history.model(), theirs));
  const Event& event = earlier->history.events().back();
  EXPECT_EQ(event.kind, EventKind::kEdit);
  EXPECT_EQ(event.label, "changed");
  EXPECT_EQ(event.stamp.author, "another program");
  EXPECT_EQ(earlier->kept, 3U);
  ASSERT_TRUE(earlier->history.undo(kBen));
  EXPECT_TRUE(sameBits(earlier->history.model(), history_.model()));
}

TEST_F(EarlierHistoryTest, AModelWithOtherInputsHasAHistoryOfItsOwn) {
  fuzzy::ForceModel other = support::s4AsPrinted();
  other.inputs[0].id = "grease";
  for (auto& expert : other.experts) {
    for (auto& rule : expert.rules) {
      for (auto& condition : rule.conditions) {
        if (condition.input == "lubrication") condition.input = "grease";
      }
    }
  }
  const auto refused = reopened(other);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message(), "the history: found a model with other inputs, wanted the inputs of the file");
}

TEST_F(EarlierHistoryTest, ADragThatWasInProgressIsOffered) {
  study::RecordIds ids(3);
  auto versions = unstoredVersions(history_);
  history_.update(foot(135));
  versions.push_back(dragVersion(history_, ids, 2000));
  EXPECT_TRUE(isDrag(versions.back()));
  auto split = withoutDrags(versions);
  ASSERT_TRUE(split);
  EXPECT_EQ(split->versions.size(), 3U);
  ASSERT_TRUE(split->unfinished);
  EXPECT_TRUE(sameBits(split->unfinished->model, foot(135).model));

  // All of it: the drag is the last edit.
  auto whole = wholeHistory(*split, ids, kBen).value();
  EXPECT_TRUE(sameBits(whole.model(), foot(135).model));
  EXPECT_EQ(whole.labelOf(whole.current()), "Depth / nasopharynx: right foot 131 to 135 mm (recovered)");

  history_.cancel();
  const auto earlier = goOn(std::move(*split), opened(history_.model()), ids, "changed", kBen);
  ASSERT_TRUE(earlier);
  EXPECT_EQ(earlier->lost, 2U);
  EXPECT_EQ(earlier->edits, 1U);
  ASSERT_TRUE(earlier->drag);

  // It ended without an edit: the model before it follows.
  versions.push_back(dragVersion(history_, ids, 3000));
  split = withoutDrags(versions);
  ASSERT_TRUE(split);
  EXPECT_EQ(split->versions.size(), 3U);
  EXPECT_FALSE(split->unfinished);
}

TEST_F(EarlierHistoryTest, NothingToGoOnWithIsRefused) {
  EXPECT_FALSE(goOn({}, opened(history_.model()), study::RecordIds(8), "changed", kBen));
  auto versions = unstoredVersions(history_);
  versions.back().text = "{}";
  EXPECT_FALSE(goOn({versions, {}}, opened(history_.model()), study::RecordIds(8), "changed", kBen));
}

}  // namespace
}  // namespace tactus::editing
