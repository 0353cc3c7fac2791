#include "core/haptics/device/device_calibration.h"

#include <cmath>

#include "core/base/check.h"
#include "core/base/text.h"

namespace tactus::haptics {
namespace {

using base::ErrorCode;
using base::Result;

constexpr double kUnitTolerance = 1e-6;  // a direction that went through a text of six digits is still one

Result<void> inRange(const char* key, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return base::fail(ErrorCode::kValue, key, base::formatNumber(value),
                    "a number from " + base::formatNumber(low) + " to " + base::formatNumber(high));
}

bool isSign(double value) { return value == 1 || value == -1; }

}  // namespace

Result<void> checkCalibration(const DeviceCalibration& c) {
  if (c.device.empty()) return base::fail(ErrorCode::kValue, "device", "nothing", "the id of a device");
  if (auto ok = inRange("full_scale_n", c.full_scale_n, 0.05, 500); !ok) return ok;
  if (auto ok = inRange("mm_per_count", c.mm_per_count, 1e-6, 100); !ok) return ok;
  if (!isSign(c.force_sign.x) || !isSign(c.force_sign.y) || !isSign(c.force_sign.z))
    return base::fail(ErrorCode::kValue, "force_sign", "another number", "1 or -1 three times");
  if (auto ok = checkDirection("inwards", c.inwards); !ok) return ok;
  for (const double coordinate : {c.origin_mm.x, c.origin_mm.y, c.origin_mm.z}) {
    if (auto ok = inRange("origin_mm", coordinate, -1e5, 1e5); !ok) return ok;
  }
  if (c.friction_in_n) {
    if (auto ok = inRange("friction_in_n", *c.friction_in_n, 0, c.full_scale_n); !ok) return ok;
  }
  if (c.friction_out_n) return inRange("friction_out_n", *c.friction_out_n, 0, c.full_scale_n);
  return {};
}

Result<void> checkDirection(const char* key, const Vector3& direction) {
  const double length = std::sqrt(dot(direction, direction));
  if (std::abs(length - 1) <= kUnitTolerance) return {};
  return base::fail(ErrorCode::kValue, key, "a vector of length " + base::formatNumber(length), "length 1");
}

AxisMapping axisOf(const DeviceCalibration& calibration) {
  auto axis = AxisMapping::make(calibration.inwards, calibration.origin_mm);
  TACTUS_CHECK(axis);
  return *axis;
}

}  // namespace tactus::haptics
