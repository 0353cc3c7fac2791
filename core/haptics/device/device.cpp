#include "core/haptics/device/device.h"

namespace tactus::haptics {

std::string_view describe(DeviceFault fault) noexcept {
  switch (fault) {
    case DeviceFault::kNone:
      return "the device reports no fault";
    case DeviceFault::kLost:
      return "the device is gone";
    case DeviceFault::kNotCalibrated:
      return "the device is not calibrated";
    case DeviceFault::kSwitchedOff:
      return "a switch, the device itself or another program holds the forces back";
    case DeviceFault::kWarmMotors:
      return "the motors are too warm";
    case DeviceFault::kForceLimited:
      return "the device refused a force";
    case DeviceFault::kFailed:
      return "the device reports a fault";
  }
  return "the device reports an unknown fault";
}

}  // namespace tactus::haptics
