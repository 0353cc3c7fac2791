#include "elicitation/depth/insertion_length.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tactus::elicitation {
namespace {

// 0.38696 * 500 = 193.48.
TEST(InsertionLength, ByThreeFormulas) {
  const auto lengths = insertionLengths(500);
  ASSERT_TRUE(lengths) << lengths.error().message();
  ASSERT_EQ(lengths->size(), 3U);
  EXPECT_EQ((*lengths)[0].length_mm, 500);
  EXPECT_NEAR((*lengths)[1].length_mm, 497.18, 1e-9);
  EXPECT_NEAR((*lengths)[2].length_mm, 557.18, 1e-9);
  // The sphincter lies at 440 mm, the target 30 to 100 mm beyond it.
  EXPECT_EQ((*lengths)[0].beyond_sphincter_mm, 60);
  EXPECT_TRUE((*lengths)[0].in_target);
  EXPECT_TRUE((*lengths)[1].in_target);
  EXPECT_FALSE((*lengths)[2].in_target);
}

TEST(InsertionLength, TheTargetFollowsTheAnatomy) {
  EXPECT_EQ(targetDepth().from_mm, 470);
  EXPECT_EQ(targetDepth().to_mm, 540);
  EXPECT_NEAR(targetDepth(0.93).from_mm, 439.2, 1e-9);
  EXPECT_NEAR(targetDepth(1.05).to_mm, 562, 1e-9);
  EXPECT_TRUE(insertionLengths(500, 1.05)->at(2).in_target) << "557.18 mm";
}

TEST(InsertionLength, AMeasuredSphincterMovesTheTarget) {
  EXPECT_EQ(targetDepth(1, 420).from_mm, 450);
  const auto lengths = insertionLengths(500, 1, 420).value();
  EXPECT_EQ(lengths[0].beyond_sphincter_mm, 80);
  EXPECT_FALSE(lengths[2].in_target) << "557 mm, the target ends at 520 mm";
}

TEST(InsertionLength, RefusesAnotherUnitAndAnImpossibleScale) {
  const auto in_cm = insertionLengths(50);
  ASSERT_FALSE(in_cm);
  EXPECT_EQ(in_cm.error().message(), "nose-ear-xiphoid length: found 50 mm, wanted a length of adults, 300 to 800 mm");
  EXPECT_FALSE(insertionLengths(500, 0.4));
  EXPECT_FALSE(insertionLengths(500, std::nan("")));
}

}  // namespace
}  // namespace tactus::elicitation
