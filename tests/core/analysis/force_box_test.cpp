#include <gtest/gtest.h>

#include "core/analysis/force_difference.h"

#include "tests/support/ngt_model.h"

namespace tactus::analysis {
namespace {

// The Halton sequence: 1/2, 1/4, 3/4 in base 2; 1/3, 2/3, 1/9 in base 3; and so on for 5 and 7.
TEST(ForceBox, IsTheHaltonSequenceOverTheUniverses) {
  const auto points = boxPoints(support::ngtVariables(), 3);
  ASSERT_EQ(points.size(), 3U);
  const std::vector<double> first = {1.0 / 2, 90.0 / 3, 600.0 / 5, 400.0 / 7};
  for (std::size_t k = 0; k < first.size(); ++k) EXPECT_DOUBLE_EQ(points[0][k], first[k]);
  EXPECT_DOUBLE_EQ(points[2][0], 3.0 / 4);
  EXPECT_DOUBLE_EQ(points[2][1], 90.0 / 9);
  EXPECT_DOUBLE_EQ(points[2][2], 600.0 * 3 / 5);
  EXPECT_DOUBLE_EQ(points[2][3], 400.0 * 3 / 7);
}

TEST(ForceBox, ALineHoldsBothEnds) {
  const auto points = linePoints(support::ngtVariables(), {1, 60, 0, 50}, 2, 601);
  ASSERT_EQ(points.size(), 601U);
  EXPECT_EQ(points.front(), (std::vector<double>{1, 60, 0, 50}));
  EXPECT_DOUBLE_EQ(points[200][2], 200);
  EXPECT_EQ(points.back(), (std::vector<double>{1, 60, 600, 50}));
}

}  // namespace
}  // namespace tactus::analysis
