#include "elicitation/force/noticeable_force.h"

#include <gtest/gtest.h>

#include "tests/support/ngt_model.h"

namespace tactus::elicitation {
namespace {

// Reference figures of another program: rule 3 of the published expert says Large instead of Small; the stroke goes
// from 190 to 210 mm at 5 mm/s, lubrication 1, neck flexion 60. Half of the last digit is allowed.
TEST(StrokeDifference, OfOneRule) {
  const fuzzy::ForceModel before = support::s4FiveRegions();
  fuzzy::ForceModel after = before;
  after.experts[0].rules[2].then = "large";
  const auto first = fuzzy::compile(before);
  const auto second = fuzzy::compile(after);
  ASSERT_TRUE(first && second);
  const auto difference = strokeDifference(*first, *second, {1, 60, 0, 5}, 2, 190, 210);
  EXPECT_NEAR(difference.largest_jnd, 1.2393, 5e-5);
  EXPECT_NEAR(difference.largest_n, .09301, 5e-6);
  EXPECT_EQ(difference.at_mm, 190);
  EXPECT_EQ(difference.places, 21U);
  EXPECT_EQ(difference.without_one, 0U);
  EXPECT_GT(difference.rms_jnd, 0);
  EXPECT_LT(difference.rms_jnd, difference.largest_jnd);
  EXPECT_GT(difference.mean_n, 0);

  const auto back = strokeDifference(*second, *first, {1, 60, 0, 5}, 2, 190, 210);
  EXPECT_DOUBLE_EQ(back.mean_n, -difference.mean_n);
  const auto none = strokeDifference(*first, *first, {1, 60, 0, 5}, 2, 190, 210);
  EXPECT_EQ(none.rms_jnd, 0);
  EXPECT_EQ(none.largest_n, 0);
}

}  // namespace
}  // namespace tactus::elicitation
