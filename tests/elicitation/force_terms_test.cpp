#include "elicitation/force_terms.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/fuzzy/membership.h"
#include "elicitation/ngt_variables.h"

#include "tests/elicitation/table2.h"

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
  const auto terms = forceTerms(ngtOutput(), vote(table2()));
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
  const auto terms = forceTerms(ngtOutput(), won({{0.1, 0}, {0.2, 0}, {0.5, 3}, {0.6, 3}, {0.7, 4}}));
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
  const auto terms = forceTerms(ngtOutput(), won({{0.3, 2}, {0.6, 3}, {0.9, 4}}));
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
  // The universe ends at the last rated step, so nothing fits above it; a first step at 0 N leaves nothing below.
  const auto terms = forceTerms(ngtOutput(), won({{0.0, 1}, {0.4, 2}, {0.5, 3}, {0.6, std::nullopt}}));
  ASSERT_TRUE(terms);
  EXPECT_EQ(terms->absent, (std::vector<std::string>{"very_small", "very_large"}));
  EXPECT_EQ(terms->output.max, 0.5);
  EXPECT_EQ(points(*terms, "small"), (std::vector<double>{0, 0, 0, 0.4}));
  EXPECT_EQ(points(*terms, "large"), (std::vector<double>{0.4, 0.5, 0.5, 0.5}));
}

TEST(ForceTerms, NothingDecidedIsRefused) {
  EXPECT_FALSE(forceTerms(ngtOutput(), {}));
  EXPECT_FALSE(forceTerms(ngtOutput(), won({{0.1, std::nullopt}})));
  EXPECT_FALSE(forceTerms(ngtOutput(), won({{0.0, 1}})));
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
    const auto terms = forceTerms(ngtOutput(), vote(counts));
    ASSERT_TRUE(terms);
    for (double x = 0; x <= terms->output.max; x += 0.013) {
      double sum = 0;
      for (const auto& term : terms->output.terms) sum += fuzzy::MembershipFunction::of(term)(x);
      EXPECT_NEAR(sum, 1, 1e-12) << x;  // ramps of 0.02 N and more: rounding of x by their width
    }
  }
}

}  // namespace
}  // namespace tactus::elicitation
