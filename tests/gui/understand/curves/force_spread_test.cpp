#include "app/workbench/understand/curves/force_spread.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tactus::workbench {
namespace {

using fuzzy::Evaluation;

/// One place, forces of the experts as given; NaN: no rule fires.
figures::ForceCurves at(std::initializer_list<double> forces, double mean_n) {
  figures::ForceCurves curves;
  curves.x = {0};
  curves.mean = {{mean_n, true}};
  for (const double force : forces) {
    curves.experts.push_back({std::isnan(force) ? Evaluation{} : Evaluation{force, true}});
  }
  return curves;
}

TEST(ForceSpread, OfFourExpertsIsWhatTheFourSay) {
  // Deviations -0.3, -0.1, 0.1, 0.3: squares add up to 0.2, over n - 1 = 3.
  const ForceSpread spread = spreadOf(at({0.2, 0.4, 0.6, 0.8}, 0.5), std::vector<double>(4, 1));
  EXPECT_EQ(spread.lowest_n[0], 0.2);
  EXPECT_EQ(spread.highest_n[0], 0.8);
  const double deviation = std::sqrt(0.2 / 3);
  EXPECT_NEAR(spread.deviation_n[0], deviation, 1e-15);
  EXPECT_NEAR(spread.minus_sd_n[0], 0.5 - deviation, 1e-15);
  EXPECT_NEAR(spread.plus_sd_n[0], 0.5 + deviation, 1e-15);
}

TEST(ForceSpread, OnlyTheRatiosOfTheWeightsCount) {
  const figures::ForceCurves curves = at({0.2, 0.4, 0.6, 0.8}, 0.5);
  const ForceSpread one = spreadOf(curves, std::vector<double>(4, 1));
  const ForceSpread huge = spreadOf(curves, fuzzy::normalizedWeights(std::vector<double>(4, 1e300)));
  EXPECT_NEAR(one.plus_sd_n[0], huge.plus_sd_n[0], 1e-15);
  // Weights 2, 1, 1: mean 0.25, sum w d^2 = 2 * 0.0625 + 2 * 0.0625 = 0.25, over 4 - 6 / 4 = 2.5.
  const ForceSpread weighted = spreadOf(at({0, 0.5, 0.5}, 0.25), std::vector<double>{2, 1, 1});
  EXPECT_NEAR(weighted.plus_sd_n[0], 0.25 + std::sqrt(0.1), 1e-15);
}

TEST(ForceSpread, WhoIsSilentOrWithoutWeightIsNotThere) {
  const double silent = std::nan("");
  const ForceSpread two = spreadOf(at({0.2, silent, 0.6, 9}, 0.4), std::vector<double>{1, 1, 1, 0});
  EXPECT_EQ(two.lowest_n[0], 0.2);
  EXPECT_EQ(two.highest_n[0], 0.6);
  EXPECT_TRUE(std::isnan(two.plus_sd_n[0]));  // two say nothing about a deviation
  const ForceSpread one = spreadOf(at({0.2, silent}, 0.2), std::vector<double>{1, 1});
  EXPECT_TRUE(std::isnan(one.lowest_n[0]));
}

}  // namespace
}  // namespace tactus::workbench
