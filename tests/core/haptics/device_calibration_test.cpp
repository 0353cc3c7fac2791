#include "core/haptics/device_calibration.h"

#include <gtest/gtest.h>
#include <limits>

namespace tactus::haptics {
namespace {

DeviceCalibration sample() {
  DeviceCalibration c;
  c.device = "hid:1209:ffb0:7";
  c.serial = "7";
  c.full_scale_n = 12.5;
  c.force_sign = {1, 1, -1};
  c.mm_per_count = 0.0125;
  c.inwards = {0.6, 0, -0.8};
  c.origin_mm = {1, 2, 3.25};
  c.friction_in_n = 0.31;
  c.silent_when_still = true;
  c.measured_at = "2026-11-21T08:00:00Z";
  c.procedure = "guided 1, spring scale";
  return c;
}

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
