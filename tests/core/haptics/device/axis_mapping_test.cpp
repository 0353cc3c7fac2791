#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/haptics/device/device.h"

namespace tactus::haptics {
namespace {

TEST(AxisMapping, TheDefaultPointsAwayFromThePersonAndIsLevel) {
  const AxisMapping axis;
  EXPECT_EQ(axis.positionMm({3, 4, -10}), 10);
  EXPECT_EQ(axis.speedMmS({3, 4, 25}), -25);
  EXPECT_EQ(axis.forceOnHand(0.5), (Vector3{0, 0, 0.5}));
}

TEST(AxisMapping, KeepsNothingOfTheLengthOfTheDirection) {
  for (const double length : {1e-300, 1.0, 1e300}) {
    const auto axis = AxisMapping::make({3 * length, 0, -4 * length}, {1, 2, 3});
    ASSERT_TRUE(axis) << length;
    EXPECT_NEAR(axis->inwards().x, 0.6, 1e-15);
    EXPECT_NEAR(axis->inwards().z, -0.8, 1e-15);
    EXPECT_NEAR(axis->positionMm({4, 2, -1}), 0.6 * 3 + 0.8 * 4, 1e-14);
    const Vector3 force = axis->forceOnHand(2);
    EXPECT_NEAR(std::sqrt(dot(force, force)), 2, 1e-15);
  }
}

TEST(AxisMapping, RefusesDirectionsThatAreNone) {
  EXPECT_EQ(AxisMapping::make({0, 0, 0}).error().message(),
            "direction of the insertion axis: found (0, 0, 0), wanted finite numbers that are not all 0");
  EXPECT_FALSE(AxisMapping::make({0, std::nan(""), 1}));
  EXPECT_FALSE(AxisMapping::make({0, 0, 1}, {std::numeric_limits<double>::infinity(), 0, 0}));
}

}  // namespace
}  // namespace tactus::haptics
