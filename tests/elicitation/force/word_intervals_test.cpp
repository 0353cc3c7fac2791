// By hand, on the judgements that Table 2 splits into.
#include "elicitation/force/word_intervals.h"

#include <gtest/gtest.h>

#include "tests/elicitation/four_people.h"
#include "tests/support/default_procedure.h"

namespace tactus::elicitation {
namespace {

std::vector<WordInterval> ofFour() {
  return wordIntervals(fourPeople().judgements, "ascending", support::ngtOutput().terms);
}

TEST(WordIntervals, GoFromTheLowestToTheHighestForceCalledSo) {
  const auto intervals = ofFour();
  // E1 never used the lowest word: 4 + 5 + 5 + 5.
  ASSERT_EQ(intervals.size(), 19U);
  EXPECT_EQ(intervals[0].participant, "E1");
  EXPECT_EQ(intervals[0].word, 1U);
  EXPECT_EQ(intervals[0].left_n, .1);
  EXPECT_EQ(intervals[0].right_n, .1);
  EXPECT_EQ(intervals[3].word, 4U);
  EXPECT_EQ(intervals[3].left_n, .4);
  EXPECT_EQ(intervals[3].right_n, 1.1);
  // S4: vvvSMMMMLLV
  EXPECT_EQ(intervals[14].participant, "S4");
  EXPECT_EQ(intervals[14].word, 0U);
  EXPECT_EQ(intervals[14].right_n, .3);
  EXPECT_EQ(intervals[16].left_n, .5);
  EXPECT_EQ(intervals[16].right_n, .8);
}

TEST(WordIntervals, TakeOneSeriesAndAnswersWithAWordAlone) {
  auto judgements = fourPeople().judgements;
  for (auto& one : judgements) {
    if (one.participant == "E1") one.kind = study::ForceJudgement::Kind::kNotFelt;
    if (one.participant == "E2") one.series = "random";
  }
  const auto intervals = wordIntervals(judgements, "ascending", support::ngtOutput().terms);
  ASSERT_EQ(intervals.size(), 10U);
  EXPECT_EQ(intervals.front().participant, "E3");
  EXPECT_TRUE(wordIntervals(judgements, "descending", support::ngtOutput().terms).empty());
}

// Medium: E1 at .2 N alone, E2 [.3, .4], E3 [.5, .6], S4 [.5, .8].
TEST(WordIntervals, AgreementIsTheShareOfTheIntervalsAtAForce) {
  const auto agreement = intervalAgreement(ofFour(), 2);
  const std::vector<IntervalShare> wanted = {{.2, .2, .25}, {.3, .3, .25}, {.3, .4, .25}, {.4, .4, .25}, {.5, .5, .5},
                                             {.5, .6, .5},  {.6, .6, .5},  {.6, .8, .25}, {.8, .8, .25}};
  ASSERT_EQ(agreement.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(agreement[i].left_n, wanted[i].left_n) << i;
    EXPECT_EQ(agreement[i].right_n, wanted[i].right_n) << i;
    EXPECT_EQ(agreement[i].share, wanted[i].share) << i;
  }
  // Very small: three of the four used it, and all three at .1 N.
  EXPECT_EQ(intervalAgreement(ofFour(), 0).front().share, 1);
  EXPECT_TRUE(intervalAgreement({}, 0).empty());
}

}  // namespace
}  // namespace tactus::elicitation
