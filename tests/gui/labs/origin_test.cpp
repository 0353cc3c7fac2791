// Where a number comes from, with Table 2's four participants.
#include <gtest/gtest.h>

#include "app/workbench/labs/origins/origin_finder.h"

#include "tests/elicitation/four_people.h"

namespace tactus::workbench {
namespace {

struct Four {
  Four() { study.study = elicitation::fourPeople(); }

  Origin ask(const OriginQuestion& question) const { return originOf(question, built(), study, {}); }
  const elicitation::BuiltModel& built() const {
    static const elicitation::BuiltModel kBuilt = elicitation::buildModel(study.study, {}, {}).value();
    return kBuilt;
  }

  LabStudy study;
};

// elicitation.md 3: at .9 N two say large (E3 and S4) and two very large.
TEST(Origin, AVoteIsTheJudgementsForItsWord) {
  const Origin found = Four().ask(VoteQuestion{0.9, "large"});
  ASSERT_EQ(found.records.size(), 2U);
  EXPECT_EQ(found.records[0].participant, QStringLiteral("E3"));
  EXPECT_EQ(found.records[1].participant, QStringLiteral("S4"));
  for (const OriginRecord& one : found.records) {
    EXPECT_EQ(one.says, QStringLiteral("Large"));
    EXPECT_EQ(one.what, QStringLiteral("0.9 N, step 9"));
  }
  EXPECT_EQ(Four().ask(VoteQuestion{0.9, {}}).records.size(), 4U);
  const Origin none = Four().ask(VoteQuestion{0.9, "small"});
  EXPECT_TRUE(none.records.empty());
  EXPECT_FALSE(none.notes.isEmpty());
}

// Table 2: small begins at .3 N, so its left shoulder has the four judgements there.
TEST(Origin, AVertexThatWasMovedByHandSaysWhatTheStudyGives) {
  const Origin same = Four().ask(VertexQuestion{"force", "small", 1, 0.3});
  EXPECT_EQ(same.records.size(), 4U);
  EXPECT_TRUE(same.notes.isEmpty()) << same.notes.join(QLatin1Char('\n')).toStdString();
  const Origin moved = Four().ask(VertexQuestion{"force", "small", 1, 0.35});
  EXPECT_EQ(moved.records.size(), 4U);
  ASSERT_EQ(moved.notes.size(), 1);
  EXPECT_TRUE(moved.notes.first().contains(QStringLiteral("0.3 N")));
  EXPECT_TRUE(moved.title.contains(QStringLiteral("0.35 N")));
}

TEST(Origin, ARuleIsFoundByItsConditionsAndSaysWhereTheBenchDiffers) {
  const Four four;
  fuzzy::Rule rule = four.built().model.experts[1].rules[3];
  const Origin same = four.ask(RuleQuestion{"E2", rule});
  ASSERT_EQ(same.records.size(), 1U);
  EXPECT_EQ(same.records[0].rule, (elicitation::RulePlace{1, 3}));
  EXPECT_TRUE(same.notes.isEmpty());
  rule.then = rule.then == "large" ? "small" : "large";
  EXPECT_EQ(four.ask(RuleQuestion{"E2", rule}).notes.size(), 1);
  rule.conditions.pop_back();
  const Origin added = four.ask(RuleQuestion{"E2", rule});
  EXPECT_TRUE(added.records.empty());
  EXPECT_EQ(added.notes.size(), 1);
}

TEST(Origin, SimulatedParticipantsAreNamed) {
  Four four;
  four.study.study.participants[2].simulated = true;  // E3
  const Origin found = four.ask(VoteQuestion{0.9, "large"});
  ASSERT_FALSE(found.notes.isEmpty());
  EXPECT_TRUE(found.notes.last().contains(QStringLiteral("SIMULATED")));
  EXPECT_TRUE(found.notes.last().contains(QStringLiteral("E3")));
  EXPECT_TRUE(four.ask(VoteQuestion{0.9, "very_large"}).notes.isEmpty());
}

// The other way: without E1's rules 0 to n the mean moves, and a judgement of another series moves nothing.
TEST(Origin, ARecordSaysWhatItMoves) {
  const Four four;
  const Origin rule = four.ask(RuleQuestion{"S4", four.built().model.experts[3].rules[0]});
  const auto moved = influenceOf(rule.records.at(0), four.built(), four.study, {});
  ASSERT_TRUE(moved);
  const auto direct = elicitation::withoutRule(four.built(), 3, 0);
  ASSERT_TRUE(direct);
  EXPECT_EQ(moved->difference.largest_n, direct->difference.largest_n);
  EXPECT_GT(moved->difference.largest_n, 0);
}

}  // namespace
}  // namespace tactus::workbench
