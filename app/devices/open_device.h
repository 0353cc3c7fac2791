// Opens a haptic device by the id that the list of devices gives it.
#pragma once

#include <memory>
#include <string>

#include "app/devices/device_list.h"
#include "core/base/error.h"
#include "core/haptics/device/axis_mapping.h"
#include "core/haptics/device/device.h"

namespace tactus::devices {

struct OpenedDevice {
  std::unique_ptr<haptics::HapticDevice> device;  ///< not started
  haptics::AxisMapping axis;                      ///< where the insertion axis lies, from its calibration if it has one
  std::string calibration_advice;                 ///< what to do when it says that it is not calibrated
  std::string axis_advice;  ///< what to do when inwards is outwards; empty: the axis is the device's own
};

/// `virtual`, `hid:VVVV:PPPP[:SERIAL]`, `openhaptics[:NAME]`. Refused, with what to do: an id that is none, a device
/// that is not there or cannot be opened, a file of calibrations that cannot be read.
base::Result<OpenedDevice> open(const std::string& id, const DeviceSettings& settings);

/// What to do to turn the insertion axis of a device around that its driver calibrates.
std::string turnAxisAdvice(const std::string& id, const haptics::Vector3& inwards);

/// `x,y,z` with at most four digits, as `--inwards` takes it.
std::string directionText(const haptics::Vector3& direction);

/// A HID device as it is without a calibration: positions are counts and 1 N is its full scale. For calibrating it.
base::Result<OpenedDevice> openRaw(const std::string& id);

}  // namespace tactus::devices
