#include <algorithm>
#include <gtest/gtest.h>

#include "elicitation/depth/depth_measurement.h"

#include "tests/support/default_procedure.h"

namespace tactus::elicitation {
namespace {

fuzzy::Variable depth() {
  const auto inputs = support::ngtInputs();
  return *std::find_if(inputs.begin(), inputs.end(), [](const auto& one) { return one.id == "depth"; });
}

// facts/domain.md 1.2 and 1.3.
const std::vector<DepthBoundary> kDefaults = {{70, 10}, {115, 10}, {150, 12}, {200, 15}, {440, 20}};

TEST(DepthTerms, TheDefaultBoundariesGiveTheDefaultTerms) {
  const auto terms = depthTerms(depth(), kDefaults);
  ASSERT_TRUE(terms);
  EXPECT_EQ(*terms, depth().terms);
  EXPECT_EQ(boundariesOf(*terms), kDefaults);
}

TEST(DepthTerms, AScaleMovesEachVertexAndLeavesTheUniverse) {
  const auto terms = depthTerms(depth(), kDefaults, 0.5);
  ASSERT_TRUE(terms);
  EXPECT_EQ((*terms)[1].points, (std::vector<double>{30, 40, 52.5, 62.5}));
  EXPECT_EQ(terms->back().points, (std::vector<double>{210, 230, 600, 600}));
}

TEST(DepthTerms, WithoutOverlapARegionEndsWhereTheNextBegins) {
  auto crisp = kDefaults;
  for (auto& one : crisp) one.half_overlap_mm = 0;
  const auto terms = depthTerms(depth(), crisp);
  ASSERT_TRUE(terms);
  EXPECT_EQ((*terms)[2].points, (std::vector<double>{115, 115, 150, 150}));
}

TEST(DepthTerms, WhatCannotBeIsRefusedWithTheRegions) {
  auto turned = kDefaults;
  std::swap(turned[1], turned[2]);
  const auto refused = depthTerms(depth(), turned);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("oropharynx"), std::string::npos) << refused.error().message();
  auto wide = kDefaults;
  wide[1].half_overlap_mm = 30;  // ends at 145 mm, and the next ramp begins at 138 mm
  EXPECT_FALSE(depthTerms(depth(), wide));
  auto beyond = kDefaults;
  beyond.back().depth_mm = 590;
  EXPECT_FALSE(depthTerms(depth(), beyond));
  EXPECT_FALSE(depthTerms(depth(), std::span(kDefaults).first(4)));
  EXPECT_FALSE(depthTerms(depth(), kDefaults, 0));
  EXPECT_FALSE(depthTerms(depth(), kDefaults, 1.4));  // the stomach would begin beyond the universe
}

}  // namespace
}  // namespace tactus::elicitation
