#include <gtest/gtest.h>
#include <string>

#include "app/editing/edit_history.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

using Place = HistoryRow::Place;

const Stamp kTreeByAnn{"Ann", 1000};

class HistoryTreeTest : public testing::Test {
 protected:
  void edit(double to) {
    history_.apply(must(moveVertex(history_.model(), {kDepth, "nasopharynx", 3}, to)), kTreeByAnn);
  }
  void undo() { ASSERT_TRUE(history_.undo(kTreeByAnn)); }

  /// `0. 1* 2~` : state and place; a blank per level before it.
  std::string rows() const {
    std::string out;
    for (const HistoryRow& row : historyRows(history_)) {
      out += std::string(row.level, ' ') + std::to_string(row.state);
      out += row.place == Place::kCurrent  ? '*'
             : row.place == Place::kUndone ? '~'
             : row.place == Place::kBranch ? '|'
                                           : '.';
      out += '\n';
    }
    return out;
  }

  EditHistory history_ = EditHistory::open(support::s4AsPrinted(), "S4", kTreeByAnn, study::RecordIds(1)).value();
};

TEST_F(HistoryTreeTest, ALineOfEditsAndWhatIsUndone) {
  edit(126);
  edit(127);
  edit(128);
  undo();
  EXPECT_EQ(rows(), "0.\n1.\n2*\n3~\n");
  const auto all = historyRows(history_);
  EXPECT_TRUE(all[0].starts);
  EXPECT_FALSE(all[1].starts);
  EXPECT_TRUE(all[2].goes_on);
  EXPECT_FALSE(all[3].goes_on);
}

TEST_F(HistoryTreeTest, AnEditAfterAnUndoLeavesABranch) {
  edit(126);
  edit(127);
  edit(128);
  undo();
  undo();
  edit(130);
  EXPECT_EQ(rows(), "0.\n1.\n 2|\n 3|\n4*\n");
  // Undone all the way and edited again: the older line is a branch with the branch that it had.
  undo();
  undo();
  edit(131);
  EXPECT_EQ(rows(), "0.\n 1|\n  2|\n  3|\n 4|\n5*\n");
  // To return there makes it the line.
  ASSERT_TRUE(history_.returnTo(2, kTreeByAnn));
  EXPECT_EQ(rows(), "0.\n 5|\n1.\n 4|\n2*\n3~\n");
}

TEST_F(HistoryTreeTest, NamesAndSignOffsStandAtTheirStates) {
  edit(126);
  history_.snapshot("stiffer", kTreeByAnn);
  history_.signOff({"S4", 2000});
  undo();
  history_.snapshot("as printed", kTreeByAnn);
  const auto all = historyRows(history_);
  ASSERT_EQ(all[1].marks.size(), 2U);
  EXPECT_EQ(history_.events()[all[1].marks[0]].label, "stiffer");
  EXPECT_EQ(history_.events()[all[1].marks[1]].stamp.author, "S4");
  ASSERT_EQ(all[0].marks.size(), 1U);
  EXPECT_EQ(history_.events()[all[0].marks[0]].label, "as printed");
}

}  // namespace
}  // namespace tactus::editing
