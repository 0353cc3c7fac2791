#include <gtest/gtest.h>

#include "app/workbench/tune/findings/findings_controller.h"

namespace tactus::workbench {
namespace {

using FixKind = elicitation::RuleFinding::Kind;

ShownFinding finding(FixKind kind, const char* who, const char* step, double newtons, double at) {
  ShownFinding out;
  out.finding.kind = kind;
  out.finding.newtons = newtons;
  out.who = QString::fromUtf8(who);
  out.step = QString::fromUtf8(step);
  out.along = {2, at};
  return out;
}

class FindingRows : public testing::Test {
 protected:
  std::vector<FindingRow> rows(FindingOrder order, const QSet<QString>& unfolded = {}) const {
    return findingRows(all_, {0, 1, 2, 3, 4, 5}, order, unfolded);
  }
  static std::vector<std::size_t> findings(const std::vector<FindingRow>& rows) {
    std::vector<std::size_t> out;
    for (const FindingRow& row : rows) out.push_back(row.finding);
    return out;
  }

  // Most newtons first, as the lint gives them.
  const std::vector<ShownFinding> all_ = {
      finding(FixKind::kHole, "S3", "", 0.9, 300),
      finding(FixKind::kLevelJump, "S2", "Nasopharynx → Oropharynx", 0.8, 120),
      finding(FixKind::kLevelJump, "S2", "Nasopharynx → Oropharynx", 0.7, 110),
      finding(FixKind::kLevelJump, "S2", "Oropharynx → Esophagus", 0.6, 200),
      finding(FixKind::kLevelJump, "S2", "Nasopharynx → Oropharynx", 0.5, 130),
      finding(FixKind::kHole, "S1", "", 0.4, 20),
  };
};

TEST_F(FindingRows, ThreeOfOneKindAboutOneStepAreOneRow) {
  const auto folded = rows(FindingOrder::kNewtons);
  EXPECT_EQ(findings(folded), (std::vector<std::size_t>{0, 1, 3, 5}));
  EXPECT_EQ(folded[1].members, 3U);
  EXPECT_EQ(folded[1].newtons, 0.8);
  EXPECT_EQ(groupTitle(all_[1], 3), QStringLiteral("S2 · Nasopharynx → Oropharynx: 3 jumps"));
  EXPECT_EQ(groupTitle(all_[0], 4), QStringLiteral("S3: 4 holes"));
}

TEST_F(FindingRows, AnUnfoldedGroupListsItsFindingsBelowTheHeading) {
  const auto open = rows(FindingOrder::kNewtons, {groupKey(all_[2])});
  EXPECT_EQ(findings(open), (std::vector<std::size_t>{0, 1, 1, 2, 4, 3, 5}));
  EXPECT_TRUE(open[1].unfolded);
  EXPECT_TRUE(open[2].in_group && open[2].members == 0);
}

TEST_F(FindingRows, TheOrderIsByExpertOrByPlace) {
  EXPECT_EQ(findings(rows(FindingOrder::kExpert)), (std::vector<std::size_t>{5, 1, 3, 0}));
  const auto by_place = rows(FindingOrder::kPlace);
  EXPECT_EQ(findings(by_place), (std::vector<std::size_t>{5, 2, 3, 0}));
  // The most newtons of a group stand in its heading, whichever of its findings comes first.
  EXPECT_EQ(by_place[1].newtons, 0.8);
}

}  // namespace
}  // namespace tactus::workbench
