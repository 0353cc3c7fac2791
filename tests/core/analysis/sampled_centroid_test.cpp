#include <cmath>
#include <gtest/gtest.h>

#include "core/analysis/centroid_bound.h"

#include "tests/support/ngt_model.h"

namespace tactus::analysis {
namespace {

/// Largest error over the points whose forces are known from other programs.
double largestError(const Sampling& sampling) {
  const auto model = fuzzy::compile(support::s4AsPrinted());
  const std::vector<std::vector<double>> points = {{1, 45, 30, 30},    {0, 0, 200, 200},  {1, 90, 95, 30},
                                                   {.7, 65, 440, 140}, {.3, 45, 170, 80}, {1, 0, 500, 50},
                                                   {.5, 20, 300, 110}, {.25, 60, 70, 64}, {1, 60, 600, 50}};
  double largest = 0;
  for (const auto& point : points) {
    const auto exact = model->evaluate(point);
    const auto sampled = evaluateSampled(*model, point, sampling);
    EXPECT_EQ(exact.fired, sampled.fired);
    largest = std::max(largest, std::abs(exact.force_n - sampled.force_n));
  }
  return largest;
}

// fuzzylite itself, with 1000 cells, is at most 1.5e-6 N off on these points; a hundred times that with ten times
// fewer.
TEST(SampledCentroid, MidpointsErrLikeFuzzylite) {
  const double fine = largestError({Sampling::Rule::kMidpoint, 1000});
  EXPECT_LT(fine, 1.5e-6);
  EXPECT_GT(fine, 1e-9) << "a sampled centroid cannot be that exact";
  EXPECT_GT(largestError({Sampling::Rule::kMidpoint, 100}), 10 * fine);
}

// The plain sums of MATLAB count the point at the end of the universe in full, which makes the rule one of first order:
// up to 4.5e-3 N with its 101 points.
TEST(SampledCentroid, PointsFromEndToEndErrLikeMatlab) {
  const double coarse = largestError({Sampling::Rule::kLinspace, 101});
  EXPECT_LT(coarse, 4.5e-3);
  EXPECT_NEAR(largestError({Sampling::Rule::kLinspace, 1001}) / coarse, 0.1, 0.01);
}

// By hand: three points 0, .55, 1.1 of the set "very small" (1 at 0, 0 at the others) give the centroid 0.
TEST(SampledCentroid, ThreePointsByHand) {
  const auto model = fuzzy::compile(support::s4AsPrinted());
  const auto force = evaluateSampled(*model, std::vector<double>{1, 45, 30, 30}, {Sampling::Rule::kLinspace, 3});
  EXPECT_TRUE(force.fired);
  EXPECT_EQ(force.force_n, 0);
}

TEST(SampledCentroid, ASetBetweenTheSamplesHasNoValue) {
  auto model = support::s4AsPrinted();
  model.experts[0].rules = {{{{"depth", "stomach"}}, "large"}};  // .6 to .8 N
  const auto compiled = fuzzy::compile(model);
  const auto force = evaluateSampled(*compiled, std::vector<double>{1, 45, 500, 30}, {Sampling::Rule::kLinspace, 3});
  EXPECT_TRUE(force.fired);
  EXPECT_TRUE(std::isnan(force.force_n));
}

}  // namespace
}  // namespace tactus::analysis
