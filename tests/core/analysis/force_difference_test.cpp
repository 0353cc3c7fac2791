#include "core/analysis/force_difference.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/ngt_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;

ForceDifference difference(const ForceModel& first, const ForceModel& second) {
  return forceDifference(first, fuzzy::compile(first).value(), second, fuzzy::compile(second).value());
}

/// One expert who says `word` in the lower half of the lubrication and `other` from .6 on; nothing between.
ForceModel saying(const char* word, const char* other) {
  ForceModel model = support::ngtVariables();
  model.inputs[0].terms = {{"low", "low", fuzzy::Shape::kTrapezoid, {0, 0, 0.5, 0.5}},
                           {"high", "high", fuzzy::Shape::kTrapezoid, {0.6, 0.6, 1, 1}}};
  model.experts = {
      {"E", "E", 1, {}, {{{{"lubrication", "low"}}, word, 1, true}, {{{"lubrication", "high"}}, other, 1, true}}}};
  return model;
}

TEST(ForceDifference, OfAModelToItselfIsZero) {
  const auto model = support::s4FiveRegions();
  const auto same = difference(model, model);
  EXPECT_EQ(same.largest_n, 0);
  EXPECT_EQ(same.rms_n, 0);
  EXPECT_EQ(same.only_one_fires, 0U);
  EXPECT_GT(same.points, 1000U);
}

TEST(ForceDifference, LargestAndRootMeanSquare) {
  // small .35 N, medium .55 N, large .7 N, each symmetric: .2 N apart below, .15 N above.
  const auto found = difference(saying("small", "medium"), saying("medium", "large"));
  EXPECT_NEAR(found.largest_n, 0.2, 1e-12);
  ASSERT_EQ(found.at.size(), 4U);
  EXPECT_LE(found.at[0], 0.5);
  EXPECT_NEAR(found.first_n, 0.35, 1e-12);
  EXPECT_NEAR(found.second_n, 0.55, 1e-12);
  // 5 parts of 9 with .2 N, 4 with .15 N; the points are spread evenly to about 1 %.
  EXPECT_NEAR(found.rms_n, std::sqrt((5 * 0.04 + 4 * 0.0225) / 9), 1e-3);
}

TEST(ForceDifference, NothingIsComparedWhereOnlyOneFires) {
  auto second = saying("small", "medium");
  second.experts[0].rules.pop_back();
  const auto found = difference(saying("small", "medium"), second);
  EXPECT_EQ(found.largest_n, 0);
  EXPECT_GT(found.only_one_fires, 0U);
  EXPECT_EQ(difference(second, saying("small", "medium")).only_one_fires, found.only_one_fires);
}

}  // namespace
}  // namespace tactus::analysis
