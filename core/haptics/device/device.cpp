#include "core/haptics/device/device.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace tactus::haptics {
namespace {

std::string text(const Vector3& v) {
  return "(" + base::formatNumber(v.x) + ", " + base::formatNumber(v.y) + ", " + base::formatNumber(v.z) + ")";
}

bool finite(const Vector3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

base::Result<AxisMapping> AxisMapping::make(const Vector3& inwards, const Vector3& origin_mm) {
  if (!finite(origin_mm))
    return base::fail(base::ErrorCode::kValue, "origin of the insertion axis", text(origin_mm), "finite numbers");
  const double largest = std::max({std::abs(inwards.x), std::abs(inwards.y), std::abs(inwards.z)});
  if (!finite(inwards) || largest == 0)
    return base::fail(base::ErrorCode::kValue, "direction of the insertion axis", text(inwards),
                      "finite numbers that are not all 0");
  AxisMapping mapping;
  // Scaled first, so that tiny and huge directions keep their bits.
  const Vector3 scaled{inwards.x / largest, inwards.y / largest, inwards.z / largest};
  mapping.inwards_ = (1 / std::sqrt(dot(scaled, scaled))) * scaled;
  mapping.origin_mm_ = origin_mm;
  return mapping;
}

std::string_view describe(DeviceFault fault) noexcept {
  switch (fault) {
    case DeviceFault::kNone: return "the device reports no fault";
    case DeviceFault::kLost: return "the device is gone";
    case DeviceFault::kNotCalibrated: return "the device is not calibrated";
    case DeviceFault::kSwitchedOff: return "a switch, the device itself or another program holds the forces back";
    case DeviceFault::kWarmMotors: return "the motors are too warm";
    case DeviceFault::kForceLimited: return "the device refused a force";
    case DeviceFault::kFailed: return "the device reports a fault";
  }
  return "the device reports an unknown fault";
}

}  // namespace tactus::haptics
