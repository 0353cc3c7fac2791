#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "elicitation/speed/stroke_bootstrap.h"

namespace tactus::elicitation {
namespace {

TEST(StudentT, QuantilesOfTheTables) {
  // Closed forms for one and two degrees; the others from R 4.2, qt(0.975, df).
  for (const double p : {0.6, 0.9, 0.975, 0.9995}) {
    EXPECT_NEAR(studentQuantile(p, 1) / std::tan(std::numbers::pi * (p - 0.5)), 1, 1e-10);
    EXPECT_NEAR(studentQuantile(p, 2) / ((2 * p - 1) / std::sqrt(2 * p * (1 - p))), 1, 1e-10);
  }
  EXPECT_NEAR(studentQuantile(0.975, 3), 3.182446305284263, 1e-9);
  EXPECT_NEAR(studentQuantile(0.975, 5), 2.570581835636314, 1e-9);
  EXPECT_NEAR(studentQuantile(0.975, 11), 2.200985160082949, 1e-9);
  EXPECT_NEAR(studentQuantile(0.975, 30), 2.042272456301238, 1e-9);
  EXPECT_NEAR(studentQuantile(0.975, 1e7), 1.959964, 1e-6);  // the normal distribution
  EXPECT_EQ(studentQuantile(0.5, 3), 0);
  EXPECT_EQ(studentQuantile(0.025, 3), -studentQuantile(0.975, 3));
  EXPECT_EQ(studentQuantile(1, 3), std::numeric_limits<double>::infinity());
}

TEST(DrawInterval, OfAMeanOfFourIsStudentsInterval) {
  // Strokes of 1, 2, 3, 6: mean 3, standard deviation sqrt(14 / 3), so 3 +- 3.1824 * sqrt(14 / 3) / 2. All 256 draws.
  const double strokes[] = {1, 2, 3, 6};
  std::vector<double> draws;
  for (int i = 0; i < 256; ++i) {
    draws.push_back((strokes[i % 4] + strokes[i / 4 % 4] + strokes[i / 16 % 4] + strokes[i / 64]) / 4);
  }
  const auto found = drawInterval(3, draws, spreadOf(4), -100, 0.95);
  const double half = 3.182446305284263 * std::sqrt(14.0 / 3) / 2;
  EXPECT_NEAR(found.high, 3 + half, 0.002 * half);  // standard deviation with 255 instead of 256
  EXPECT_NEAR(found.low, 3 - half, 0.002 * half);
  EXPECT_EQ(drawInterval(3, draws, spreadOf(4), 0, 0.95).low, 0);
  EXPECT_EQ(drawInterval(3, {2, 2, 2}, spreadOf(4), 0, 0.95).high, 3);
}

TEST(DrawInterval, SpreadsOfPartsByHand) {
  const std::vector<DrawSpread> parts = {spreadOf(4), spreadOf(13)};  // 3 and 12 degrees, 4/3 and 13/12
  // Widened variances 2 and 1: degrees 1 / (2/3 / 3 + 1/3 / 12) = 4, widening 3 / (3/2 + 12/13).
  const std::vector<double> variances = {1.5, 12.0 / 13};
  const auto mixed = mixedSpread(variances, parts);
  EXPECT_NEAR(mixed.degrees, 4, 1e-12);
  EXPECT_NEAR(mixed.widening, 3 / (1.5 + 12.0 / 13), 1e-12);
  // Independent persons: 1 / (4/9 / 3 + 1/9 / 12) = 6.35.
  EXPECT_NEAR(pooledSpread(variances, parts).degrees, 1 / (4.0 / 27 + 1.0 / 108), 1e-12);
  const std::vector<double> none = {0, 0};
  EXPECT_EQ(mixedSpread(none, parts).degrees, 3);
  EXPECT_EQ(pooledSpread(none, parts).degrees, 3);
}

}  // namespace
}  // namespace tactus::elicitation
