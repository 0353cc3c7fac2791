#include "core/base/statistics.h"

#include <gtest/gtest.h>
#include <vector>

namespace tactus::base {
namespace {

TEST(Statistics, MeanAndStandardDeviation) {
  // Squared deviations from 5: 9 + 1 + 1 + 1 + 0 + 0 + 4 + 16 = 32, 32 / 7 = 4.571428...
  const std::vector<double> sample = {2, 4, 4, 4, 5, 5, 7, 9};
  EXPECT_EQ(mean(sample), 5);
  EXPECT_DOUBLE_EQ(standardDeviation(sample), 2.13808993529939517);
  EXPECT_EQ(standardDeviation(std::vector<double>{3}), 0);
  EXPECT_EQ(standardDeviation(std::vector<double>{}), 0);
}

TEST(Statistics, ALargeOffsetDoesNotHurt) {
  // Exactly representable values around 1e9, deviations -1, 0, 1.
  const std::vector<double> sample = {1e9 - 1, 1e9, 1e9 + 1};
  EXPECT_EQ(mean(sample), 1e9);
  EXPECT_EQ(standardDeviation(sample), 1);
}

TEST(Statistics, QuantilesInterpolate) {
  // Type 7: position (n - 1) * share, as R's quantile() has it.
  const std::vector<double> sample = {4, 1, 3, 2};
  EXPECT_EQ(quantile(sample, 0), 1);
  EXPECT_EQ(quantile(sample, 0.25), 1.75);
  EXPECT_EQ(quantile(sample, 0.5), 2.5);
  EXPECT_EQ(quantile(sample, 1), 4);
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({9, 1, 5}), 5);
}

TEST(Statistics, DistributionFunctions) {
  EXPECT_DOUBLE_EQ(normalShare(0), 0.5);
  // Φ(1.959963984540054) = 0.975, as R's pnorm has it.
  EXPECT_NEAR(normalShare(1.959963984540054), 0.975, 1e-15);
  // I_x(2, 3) = 6x² - 8x³ + 3x⁴, its polynomial.
  for (const double x : {0.1, 0.4, 0.75}) {
    EXPECT_NEAR(incompleteBeta(2, 3, x, 1 - x), 6 * x * x - 8 * x * x * x + 3 * x * x * x * x, 1e-15);
  }
  EXPECT_EQ(incompleteBeta(2, 3, 0, 1), 0);
  EXPECT_EQ(incompleteBeta(2, 3, 1, 0), 1);
}

}  // namespace
}  // namespace tactus::base
