#include "elicitation/force/force_terms.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/fuzzy/membership.h"

#include "tests/elicitation/table2.h"
#include "tests/support/default_procedure.h"

namespace tactus::elicitation {
namespace {

/// Steps at these forces won by these terms.
std::vector<VoteStep> won(const std::vector<std::pair<double, std::optional<std::size_t>>>& list) {
  std::vector<VoteStep> steps;
  for (const auto& [force_n, term] : list) {
    VoteStep step;
    step.force_n = force_n;
    step.term = term;
    steps.push_back(step);
  }
  return steps;
}

std::vector<double> points(const ForceTerms& terms, const char* id) {
  const auto* term = fuzzy::findTerm(terms.output.terms, id);
  return term == nullptr ? std::vector<double>{} : term->points;
}

TEST(ForceTerms, TableTwoGivesThePublishedTrapezoids) {
  const auto terms = forceTerms(support::ngtOutput(), vote(table2()));
  ASSERT_TRUE(terms);
  EXPECT_EQ(points(*terms, "very_small"), (std::vector<double>{0, 0, 0.2, 0.3}));
  EXPECT_EQ(points(*terms, "small"), (std::vector<double>{0.2, 0.3, 0.4, 0.5}));
  EXPECT_EQ(points(*terms, "medium"), (std::vector<double>{0.4, 0.5, 0.6, 0.7}));
  EXPECT_EQ(points(*terms, "large"), (std::vector<double>{0.6, 0.7, 0.7, 0.8}));
  EXPECT_EQ(points(*terms, "very_large"), (std::vector<double>{0.7, 0.8, 1.1, 1.1}));
  EXPECT_EQ(terms->output.min, 0);
  EXPECT_EQ(terms->output.max, 1.1);
  EXPECT_TRUE(terms->notes.empty());
}

TEST(ForceTerms, MissingLevelsInAGapBecomeTriangles) {
  // Small and medium between 0.2 and 0.5 N: peaks at 0.3 and 0.4.
  const auto terms = forceTerms(support::ngtOutput(), won({{0.1, 0}, {0.2, 0}, {0.5, 3}, {0.6, 3}, {0.7, 4}}));
  ASSERT_TRUE(terms);
  EXPECT_EQ(terms->interpolated, (std::vector<std::string>{"small", "medium"}));
  const auto small = points(*terms, "small");
  ASSERT_EQ(small.size(), 3U);
  EXPECT_DOUBLE_EQ(small[0], 0.2);
  EXPECT_DOUBLE_EQ(small[1], 0.3);
  EXPECT_DOUBLE_EQ(small[2], 0.4);
  const auto medium = points(*terms, "medium");
  EXPECT_DOUBLE_EQ(medium[0], 0.3);
  EXPECT_DOUBLE_EQ(medium[2], 0.5);
  EXPECT_DOUBLE_EQ(points(*terms, "very_small")[3], 0.3);
  EXPECT_DOUBLE_EQ(points(*terms, "large")[0], 0.4);
  EXPECT_EQ(terms->notes.size(), 2U);
}

TEST(ForceTerms, MissingLevelsAtTheLowEndHaveAShoulder) {
  // Very small and small between 0 and 0.3 N: peaks at 0.1 and 0.2, very small shouldered at 0.
  const auto terms = forceTerms(support::ngtOutput(), won({{0.3, 2}, {0.6, 3}, {0.9, 4}}));
  ASSERT_TRUE(terms);
  const auto lowest = points(*terms, "very_small");
  ASSERT_EQ(lowest.size(), 4U);
  EXPECT_EQ(lowest[0], 0);
  EXPECT_EQ(lowest[1], 0);
  EXPECT_DOUBLE_EQ(lowest[2], 0.1);
  EXPECT_DOUBLE_EQ(lowest[3], 0.2);
  EXPECT_DOUBLE_EQ(points(*terms, "small")[2], 0.3);
  EXPECT_DOUBLE_EQ(points(*terms, "medium")[0], 0.2);
}

TEST(ForceTerms, NoRoomMeansNoTerm) {
  // A first step at 0 N leaves nothing below.
  const auto terms = forceTerms(support::ngtOutput(), won({{0.0, 1}, {0.4, 2}, {0.5, 3}, {0.6, 4}}));
  ASSERT_TRUE(terms);
  EXPECT_EQ(terms->absent, (std::vector<std::string>{"very_small"}));
  EXPECT_EQ(points(*terms, "small"), (std::vector<double>{0, 0, 0, 0.4}));
}

TEST(ForceTerms, AMissingTopTermLiesOneStepAbove) {
  // All say "beyond" at 0.8 N and above: large ends at 0.7 N, very large begins there.
  const auto terms = forceTerms(support::ngtOutput(), won({{0.1, 0},
                                                           {0.2, 0},
                                                           {0.3, 1},
                                                           {0.4, 1},
                                                           {0.5, 2},
                                                           {0.6, 3},
                                                           {0.7, 3},
                                                           {0.8, std::nullopt},
                                                           {0.9, std::nullopt}}));
  ASSERT_TRUE(terms);
  EXPECT_TRUE(terms->absent.empty());
  EXPECT_EQ(terms->interpolated, (std::vector<std::string>{"very_large"}));
  EXPECT_EQ(points(*terms, "large"), (std::vector<double>{0.5, 0.6, 0.7, 0.8}));
  EXPECT_EQ(points(*terms, "very_large"), (std::vector<double>{0.7, 0.8, 0.8, 0.8}));
  EXPECT_EQ(terms->output.max, 0.8);
  EXPECT_EQ(terms->notes,
            (std::vector<std::string>{"No force up to 0.7 N was given 'very_large': its term is placed one "
                                      "step above, at 0.8 N."}));
  EXPECT_EQ(terms->end_reason, "one step above the last force with a term");
}

TEST(ForceTerms, SeveralMissingTopTermsLieAStepApart) {
  // No judgement is above medium, so the steps continue as they were: 0.1 N apart.
  const auto terms = forceTerms(support::ngtOutput(), won({{0.1, 0}, {0.2, 1}, {0.3, 2}}));
  ASSERT_TRUE(terms);
  EXPECT_EQ(points(*terms, "medium"), (std::vector<double>{0.2, 0.3, 0.3, 0.4}));
  EXPECT_EQ(points(*terms, "large"), (std::vector<double>{0.3, 0.4, 0.5}));  // a triangle
  EXPECT_EQ(points(*terms, "very_large"), (std::vector<double>{0.4, 0.5, 0.5, 0.5}));
  EXPECT_EQ(terms->output.max, 0.5);
}

/// Four participants who vote up to 0.8 N, one of them alone up to 1.2 N.
std::vector<VoteStep> oneTalksOn() {
  std::vector<VoteCounts> counts = {{0.1, {4, 0, 0, 0, 0}}, {0.3, {0, 4, 0, 0, 0}}, {0.5, {0, 0, 4, 0, 0}},
                                    {0.7, {0, 0, 0, 4, 0}}, {0.8, {0, 0, 0, 0, 2}}, {0.9, {0, 0, 0, 0, 1}},
                                    {1.0, {0, 0, 0, 0, 1}}, {1.1, {0, 0, 0, 0, 1}}, {1.2, {0, 0, 0, 0, 1}}};
  return vote(counts, 4);
}

TEST(ForceTerms, TheUniverseEndsWithTheQuorumNotWithOneWhoGoesOn) {
  const auto terms = forceTerms(support::ngtOutput(), oneTalksOn());
  ASSERT_TRUE(terms);
  EXPECT_EQ(terms->output.max, 0.8);
  EXPECT_EQ(points(*terms, "very_large"), (std::vector<double>{0.7, 0.8, 0.8, 0.8}));
  EXPECT_EQ(terms->notes,
            (std::vector<std::string>{"Vote at 0.9, 1, 1.1, 1.2 N: above 0.8 N, the last force that enough "
                                      "participants judged; these votes shape no term."}));
  // Without them the result is the same.
  auto stopped = oneTalksOn();
  stopped.resize(5);
  EXPECT_EQ(forceTerms(support::ngtOutput(), stopped)->output, terms->output);
}

TEST(ForceTerms, AnEndThatWasAskedForIsTaken) {
  auto terms = forceTerms(support::ngtOutput(), oneTalksOn(), 1.2);
  ASSERT_TRUE(terms);
  EXPECT_EQ(points(*terms, "very_large"), (std::vector<double>{0.7, 0.8, 1.2, 1.2}));
  EXPECT_EQ(terms->output.max, 1.2);
  EXPECT_TRUE(terms->notes.empty());
  EXPECT_EQ(terms->end_reason, "as asked for");
  // Above all judgements: the shoulder continues.
  terms = forceTerms(support::ngtOutput(), oneTalksOn(), 2);
  EXPECT_EQ(points(*terms, "very_large"), (std::vector<double>{0.7, 0.8, 2, 2}));
  // Below them: what begins there does not exist, what lies across is cut.
  terms = forceTerms(support::ngtOutput(), oneTalksOn(), 0.5);
  ASSERT_TRUE(terms);
  EXPECT_EQ(terms->absent, (std::vector<std::string>{"large", "very_large"}));
  EXPECT_EQ(points(*terms, "medium"), (std::vector<double>{0.3, 0.5, 0.5, 0.5}));
  terms = forceTerms(support::ngtOutput(), oneTalksOn(), 0.6);
  EXPECT_EQ(terms->absent, (std::vector<std::string>{"very_large"}));
  EXPECT_EQ(points(*terms, "large"), (std::vector<double>{0.5, 0.7, 0.7, 0.7}));
  EXPECT_EQ(terms->output.max, 0.6);
}

TEST(ForceTerms, WithoutAQuorumAnywhereHalfOfTheMostVotesDecides) {
  // Ten are enrolled, three judge, one of them alone at 0.6 N.
  const std::vector<VoteCounts> counts = {{0.2, {3, 0, 0, 0, 0}}, {0.4, {0, 0, 0, 0, 2}}, {0.6, {0, 0, 0, 0, 1}}};
  const auto terms = forceTerms(support::ngtOutput(), vote(counts, 10));
  ASSERT_TRUE(terms);
  EXPECT_EQ(terms->output.max, 0.4);
  EXPECT_NE(terms->notes.front().find("Less than half of the participants judged any force"), std::string::npos);
}

TEST(ForceTerms, NothingDecidedIsRefused) {
  EXPECT_FALSE(forceTerms(support::ngtOutput(), {}));
  EXPECT_FALSE(forceTerms(support::ngtOutput(), won({{0.1, std::nullopt}})));
  EXPECT_FALSE(forceTerms(support::ngtOutput(), won({{0.0, 1}})));
}

TEST(ForceTerms, RandomVotesGiveTermsThatSumToOne) {
  base::Random random(3);
  for (int round = 0; round < 200; ++round) {
    std::vector<VoteCounts> counts;
    for (int step = 1; step <= 9; ++step) {
      VoteCounts one{0.1 * step, std::vector<int>(5)};
      for (int voter = 0; voter < 6; ++voter) {
        if (random.below(4) > 0) ++one.votes[static_cast<std::size_t>(random.below(5))];
      }
      counts.push_back(one);
    }
    const auto terms = forceTerms(support::ngtOutput(), vote(counts));
    ASSERT_TRUE(terms);
    for (double x = 0; x <= terms->output.max; x += 0.013) {
      double sum = 0;
      for (const auto& term : terms->output.terms) sum += fuzzy::MembershipFunction::of(term)(x);
      EXPECT_NEAR(sum, 1, 1e-12) << x;  // ramps of 0.02 N and more: rounding of x by their width
    }
  }
}

// At 0.2 N three words have one vote each, none of them half: the rule gives one above that of 0.1 N, which is small
// and which nobody said. By hand: with the most frequent word (the higher of several, so large) the core of small is
// gone and that of large begins at 0.2 N.
TEST(UnsaidWords, AreNamedWithWhatTheyMove) {
  const fuzzy::Variable output = support::ngtOutput();
  const std::vector<VoteCounts> counts = {
      {0.1, {3, 0, 0, 0, 0}}, {0.2, {1, 0, 1, 1, 0}}, {0.3, {0, 0, 2, 1, 0}}, {0.4, {0, 0, 0, 3, 0}}};
  const auto steps = vote(counts);
  ASSERT_EQ(steps[1].term, 1U);
  EXPECT_TRUE(isUnsaid(steps[1]));
  EXPECT_FALSE(isMostFrequent(steps[1]));
  EXPECT_FALSE(isUnsaid(steps[0]));
  EXPECT_TRUE(isMostFrequent(steps[2]));
  const auto notes = unsaidNotes(output, steps);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0], "Nobody said " + output.terms[1].label + " at 0.2 N: the rule of the vote gives the word.");
  EXPECT_EQ(notes[1].find("1 of 4 winners is not the most frequent word; with those the words move by up to 0."), 0U)
      << notes[1];
  EXPECT_NE(notes[1].find("--force-terms"), std::string::npos);
  // Nothing to say where each winner is a most frequent word.
  EXPECT_TRUE(
      unsaidNotes(output, vote(std::vector<VoteCounts>{{0.1, {2, 1, 0, 0, 0}}, {0.2, {0, 3, 0, 0, 0}}})).empty());
}

}  // namespace
}  // namespace tactus::elicitation
