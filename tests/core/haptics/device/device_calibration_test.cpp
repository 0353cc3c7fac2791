#include <gtest/gtest.h>
#include <limits>

#include "core/haptics/device/calibration_file.h"

#include "tests/core/haptics/device/sample_calibration.h"

namespace tactus::haptics {
namespace {

TEST(DeviceCalibration, NumbersThatAreNoneAreRefused) {
  auto c = sample();
  EXPECT_TRUE(checkCalibration(c));
  c.full_scale_n = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(checkCalibration(c));
  c = sample();
  c.origin_mm.y = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(checkCalibration(c));
  c = sample();
  c.inwards = {};
  EXPECT_FALSE(checkCalibration(c));
}

TEST(DeviceCalibration, GivesTheInsertionAxis) {
  const AxisMapping axis = axisOf(sample());
  EXPECT_NEAR(axis.positionMm({1.6, 2, 2.45}), 0.6 * 0.6 + 0.8 * 0.8, 1e-12);
}

}  // namespace
}  // namespace tactus::haptics
