// Opens a haptic device by its id in the list of devices.
#pragma once

#include <memory>
#include <string>

#include "app/devices/device_list.h"
#include "core/base/error.h"
#include "core/haptics/device/device.h"

namespace tactus::devices {

struct OpenedDevice {
  std::unique_ptr<haptics::HapticDevice> device;  ///< not started
  haptics::AxisMapping axis;                      ///< direction of the insertion axis; from the calibration if there is
                                                  ///< one
  std::string calibration_advice;                 ///< what to do if the device reports that it is not calibrated
  std::string axis_advice;  ///< what to do if inward and outward are swapped; empty: the axis is the device's own
};

/// Opens `virtual`, `hid:VVVV:PPPP[:SERIAL]` or `openhaptics[:NAME]`. Refused, with advice: an invalid id, a device
/// that is missing or cannot be opened, a calibration file that cannot be read.
base::Result<OpenedDevice> open(const std::string& id, const DeviceSettings& settings);

/// How to reverse the insertion axis of a device that its driver calibrates.
std::string turnAxisAdvice(const std::string& id, const haptics::Vector3& inwards);

/// `x,y,z` with at most four digits, the format of `--inwards`.
std::string directionText(const haptics::Vector3& direction);

/// A HID device without its calibration: positions are counts, and 1 N is full scale. For calibrating it.
base::Result<OpenedDevice> openRaw(const std::string& id);

}  // namespace tactus::devices
