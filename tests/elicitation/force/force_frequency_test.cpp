#include "elicitation/force/force_frequency.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/fuzzy/membership.h"

#include "tests/elicitation/table2.h"

namespace tactus::elicitation {
namespace {

using Points = std::vector<double>;

fuzzy::Variable termsOf(std::size_t count) {
  fuzzy::Variable out{.id = "force", .label = "", .unit = "N", .min = 0, .max = 1.1, .terms = {}};
  for (std::size_t k = 0; k < count; ++k) out.terms.push_back({"t" + std::to_string(k), "", {}, {}});
  return out;
}

FrequencyTerms fitted(const std::vector<VoteCounts>& counts) {
  auto terms = frequencyTerms(termsOf(counts.front().votes.size()), vote(counts));
  EXPECT_TRUE(terms);
  return std::move(*terms);
}

/// `expected` per term; `tolerance_n` as the caller explains.
void expectTerms(const FrequencyTerms& terms, const std::vector<Points>& expected, double tolerance_n) {
  ASSERT_EQ(terms.output.terms.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(terms.output.terms[k].points[i], expected[k][i], tolerance_n) << terms.output.terms[k].id << ' ' << i;
    }
  }
}

/// Share of the terms above `k` where the ramps are `ramps`.
double above(const std::vector<TermRamp>& ramps, std::size_t k, double force_n) {
  const auto& ramp = ramps[k];
  if (force_n <= ramp.begin_n) return 0;
  return force_n >= ramp.end_n ? 1 : (force_n - ramp.begin_n) / (ramp.end_n - ramp.begin_n);
}

double lossOf(const std::vector<FrequencyPoint>& points, const std::vector<TermRamp>& ramps) {
  double sum = 0;
  for (const auto& point : points) {
    for (std::size_t k = 0; k < point.shares.size(); ++k) {
      const double reached = k == 0 ? 1 : above(ramps, k - 1, point.force_n);
      const double left = k < ramps.size() ? above(ramps, k, point.force_n) : 0;
      sum += point.weight * std::pow(reached - left - point.shares[k], 2);
    }
  }
  return sum;
}

TEST(ForceFrequency, RecoversTheTrapezoidsThatMadeTheShares) {
  const std::vector<TermRamp> ramps{{0.12, 0.27}, {0.31, 0.48}, {0.48, 0.72}, {0.8, 0.97}};
  std::vector<FrequencyPoint> points;
  for (int i = 1; i <= 44; ++i) {
    FrequencyPoint point{0.025 * i, static_cast<double>(1 + i % 3), {}};
    for (std::size_t k = 0; k < 5; ++k) {
      const double reached = k == 0 ? 1 : above(ramps, k - 1, point.force_n);
      point.shares.push_back(reached - (k < 4 ? above(ramps, k, point.force_n) : 0));
    }
    points.push_back(std::move(point));
  }
  const auto found = fitRamps(points, 0, 1.1);
  ASSERT_EQ(found.size(), ramps.size());
  for (std::size_t k = 0; k < ramps.size(); ++k) {
    EXPECT_NEAR(found[k].begin_n, ramps[k].begin_n, 1.01e-6);  // ends are rounded to a micronewton
    EXPECT_NEAR(found[k].end_n, ramps[k].end_n, 1.01e-6);
  }
}

TEST(ForceFrequency, Table2HasTheLeastSquaresOfAnotherProgram) {
  // scipy 1.10.1, differential_evolution over the eight ends, six seeds, the same sum of squares; it stops at 1e-6.
  const auto terms = fitted(table2());
  expectTerms(terms,
              {{0, 0, 0.060483, 0.366709},
               {0.060483, 0.366709, 0.366709, 0.534556},
               {0.366709, 0.534556, 0.553842, 0.653842},
               {0.553842, 0.653842, 0.653842, 1.068841},
               {0.653842, 1.068841, 1.1, 1.1}},
              2e-6);
  EXPECT_NEAR(terms.rms_error, 0.169010225, 1e-8);  // the same run
  EXPECT_EQ(terms.steps[2].shares, (std::vector<double>{0.25, 0.25, 0.25, 0.25, 0}));
  EXPECT_TRUE(terms.absent.empty());
}

TEST(ForceFrequency, OneVoterGivesRampsBetweenTheStepsLikeTheVote) {
  const auto terms = fitted({{0.1, {1, 0, 0}}, {0.2, {1, 0, 0}}, {0.3, {0, 1, 0}}, {0.4, {0, 0, 1}}, {0.5, {0, 0, 1}}});
  // Exact fits leave the ramps open between neighboring steps; the widest are taken. Rounded to a micronewton.
  expectTerms(terms, {{0, 0, 0.2, 0.3}, {0.2, 0.3, 0.3, 0.4}, {0.3, 0.4, 0.5, 0.5}}, 1e-6);
  EXPECT_NEAR(terms.rms_error, 0, 1e-5);  // of the rounding
}

TEST(ForceFrequency, AllTheSameAnswerLeavesOneCore) {
  std::vector<VoteCounts> counts;
  for (int i = 1; i <= 11; ++i) counts.push_back({0.1 * i, {0, 0, 4, 0, 0}});
  const auto terms = fitted(counts);
  // The lower terms share the gap below the first force, the upper ones lie a step apart above the last.
  expectTerms(
      terms, {{0, 0, 0, 0.05}, {0, 0.05, 0.05, 0.1}, {0.05, 0.1, 1.1, 1.2}, {1.1, 1.2, 1.2, 1.3}, {1.2, 1.3, 1.3, 1.3}},
      1e-6);
  EXPECT_EQ(terms.interpolated, (std::vector<std::string>{"t0", "t1", "t3", "t4"}));
  EXPECT_TRUE(terms.absent.empty());
}

TEST(ForceFrequency, ATermThatNobodyChoseLiesBetweenItsNeighbors) {
  const auto terms = fitted({{0.1, {2, 0, 0, 0}}, {0.4, {0, 0, 0, 2}}});
  expectTerms(terms, {{0, 0, 0.1, 0.2}, {0.1, 0.2, 0.2, 0.3}, {0.2, 0.3, 0.3, 0.4}, {0.3, 0.4, 0.4, 0.4}}, 1e-6);
  EXPECT_EQ(terms.interpolated, (std::vector<std::string>{"t1", "t2"}));
}

TEST(ForceFrequency, StepsWithoutVotesSayNothing) {
  const auto with = fitted({{0.1, {2, 0}}, {0.2, {0, 0}}, {0.3, {0, 2}}, {0.4, {0, 0}}});
  const auto without = fitted({{0.1, {2, 0}}, {0.3, {0, 2}}});
  EXPECT_EQ(with.output, without.output);
  EXPECT_TRUE(with.steps[1].shares.empty());
  EXPECT_EQ(with.output.max, 0.3);
}

TEST(ForceFrequency, RefusesVotesThatSayNothing) {
  EXPECT_FALSE(frequencyTerms(termsOf(2), vote(std::vector<VoteCounts>{{0.1, {0, 0}}})));
  EXPECT_FALSE(frequencyTerms(termsOf(2), vote(std::vector<VoteCounts>{{0, {1, 0}}})));
  EXPECT_FALSE(frequencyTerms(termsOf(2), {}));
}

TEST(ForceFrequency, OneTermNeedsNoRamp) {
  const auto terms = fitted({{0.5, {3}}});
  expectTerms(terms, {{0, 0, 0.5, 0.5}}, 0);
}

/// Whether no ramp is steeper than answers every `finest_n` can tell, see force_frequency_fit.h.
bool allowed(const std::vector<TermRamp>& ramps, const std::vector<FrequencyPoint>& points, double finest_n) {
  return std::all_of(ramps.begin(), ramps.end(), [&](const TermRamp& ramp) {
    if (ramp.end_n <= points.front().force_n || ramp.begin_n >= points.back().force_n) return true;
    const bool holds = std::any_of(points.begin(), points.end(), [&ramp](const FrequencyPoint& point) {
      return point.force_n > ramp.begin_n && point.force_n < ramp.end_n;
    });
    return ramp.end_n - ramp.begin_n >= (holds ? finest_n : finest_n / static_cast<double>(2 * ramps.size()));
  });
}

TEST(ForceFrequency, NoRandomRampsAreCloserToRandomVotes) {
  base::Random random(4);
  for (int study = 0; study < 60; ++study) {
    const auto terms = static_cast<std::size_t>(2 + random.below(4));
    std::vector<FrequencyPoint> points;
    for (int i = 1, steps = 2 + random.below(9); i <= steps; ++i) {
      FrequencyPoint point{0.1 * i, static_cast<double>(1 + random.below(6)), std::vector<double>(terms)};
      for (int vote = 0; vote < static_cast<int>(point.weight); ++vote) {
        const double middle = static_cast<double>(terms) * i / steps + random.normal();
        point.shares[static_cast<std::size_t>(std::clamp(middle, 0.0, static_cast<double>(terms) - 1))] +=
            1 / point.weight;
      }
      points.push_back(std::move(point));
    }
    const double max_n = points.back().force_n;
    const auto best = fitRamps(points, 0, max_n);
    double end_n = 0;
    for (const auto& ramp : best) {
      EXPECT_LE(end_n, ramp.begin_n);
      EXPECT_LE(ramp.begin_n, ramp.end_n);
      end_n = ramp.end_n;
    }
    EXPECT_LE(end_n, max_n);
    // A term that fills no point may lie at the very end of the universe, where `above` cannot tell it from none.
    const bool at_end = best.back().begin_n >= max_n || best.front().end_n <= 0;
    const double loss = lossOf(points, best);
    for (int attempt = 0; attempt < 3000 && !at_end; ++attempt) {
      std::vector<double> ends;
      for (std::size_t j = 0; j < 2 * best.size(); ++j) {
        // Half of them near the best, half anywhere.
        const auto& ramp = best[j / 2];
        const double from_n = j % 2 == 0 ? ramp.begin_n : ramp.end_n;
        ends.push_back(attempt % 2 == 0 ? random.uniform(0, max_n)
                                        : std::clamp(from_n + 0.02 * random.normal(), 0.0, max_n));
      }
      std::sort(ends.begin(), ends.end());
      std::vector<TermRamp> ramps;
      for (std::size_t j = 0; j < ends.size(); j += 2) ramps.push_back({ends[j], ends[j + 1]});
      if (!allowed(ramps, points, 0.1)) continue;
      EXPECT_GE(lossOf(points, ramps), loss - 1e-4);  // ends rounded to a micronewton, ramps of 0.1 N, dozens of votes
    }
  }
}

TEST(ForceFrequency, MembershipsSumToOneEverywhere) {
  const auto terms = fitted(table2());
  for (double force_n = 0; force_n <= 1.1; force_n += 0.001) {
    double sum = 0;
    for (const auto& term : terms.output.terms) sum += fuzzy::MembershipFunction::of(term)(force_n);
    EXPECT_NEAR(sum, 1, 1e-14) << force_n;  // rounding
  }
}

}  // namespace
}  // namespace tactus::elicitation
