// Which haptic devices there are, over all backends: what can be used, what cannot and what to do about it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/device/calibration_file.h"
#include "core/haptics/device/device.h"
#include "core/haptics/hid/hid_devices.h"

namespace tactus::devices {

/// Where devices are looked for.
struct DeviceSettings {
  std::string hd_library;    ///< path of libHD; empty: where the system's loader finds it
  std::string calibrations;  ///< JSON file of the calibrations of this computer
};

/// The settings of this process. TACTUS_LIBHD names the library of OpenHaptics where the loader does not find it;
/// TACTUS_CALIBRATIONS the file of calibrations, by default tactus/calibrations.json in the user's configuration folder
/// (XDG_CONFIG_HOME, else ~/.config).
DeviceSettings settingsOfProcess();

struct ListedDevice {
  std::string id;  ///< for `open`; also of a device that cannot be used
  std::string name;
  std::string serial;   ///< may be empty
  std::string backend;  ///< `virtual`, `hid-pid`, `openhaptics`, or `none` where Tactus has no way to the device
  bool simulated = false;
  bool usable = false;
  std::string reason;              ///< why it cannot be used
  std::string advice;              ///< what to do: so that it can be used, or to calibrate it
  std::optional<bool> calibrated;  ///< nothing: not known
  std::string used_by;             ///< another program that has it open; empty: none that is known
};

struct DeviceList {
  std::vector<ListedDevice> devices;  ///< the virtual device is always the last one
  std::vector<std::string> notes;     ///< about what could not be looked at
};

/// What a look at OpenHaptics showed.
struct OpenHapticsLook {
  std::optional<haptics::DeviceInfo> info;  ///< of the default device, where it opens
  bool calibrated = false;
  std::string calibration_advice;
  std::string reason;  ///< why there is none
  std::string advice;
};
/// Loads the library, opens the default device and closes it again. Nothing moves.
OpenHapticsLook lookAtOpenHaptics(const std::string& hd_library);

/// The list that follows from what was found. A Touch on USB is one device with the one behind OpenHaptics.
DeviceList listOf(const std::vector<haptics::HidDevice>& hid, const OpenHapticsLook& openhaptics,
                  const std::vector<haptics::DeviceCalibration>& calibrations);

/// Looks for devices on this computer.
DeviceList listDevices(const DeviceSettings& settings);

}  // namespace tactus::devices
