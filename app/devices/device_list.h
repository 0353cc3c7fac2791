// The list of haptic devices of all backends: usable ones, and unusable ones with a reason and advice.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/device/calibration_file.h"
#include "core/haptics/device/device.h"
#include "core/haptics/haply/haply_device.h"
#include "core/haptics/hid/hid_pid_device.h"

namespace tactus::devices {

/// The settings of the device search.
struct DeviceSettings {
  std::string hd_library;                          ///< path of libHD; empty: the system's loader finds it
  std::string calibrations;                        ///< JSON file of the calibrations of this computer
  std::uint16_t haply_port = haptics::kHaplyPort;  ///< of the Haply Inverse Service
};

/// The settings of this process. TACTUS_LIBHD is the path of the OpenHaptics library if the loader does not find it.
/// TACTUS_HAPLY_PORT is the port of the Haply Inverse Service if it has another one; 0 if it is no port.
/// TACTUS_CALIBRATIONS is the calibration file; default: tactus/calibrations.json in the user's configuration folder
/// (XDG_CONFIG_HOME, else ~/.config).
DeviceSettings settingsOfProcess();

struct ListedDevice {
  std::string id;  ///< for `open`; unusable devices have one, too
  std::string name;
  std::string serial;  ///< may be empty
  std::string
      backend;  ///< `virtual`, `hid-pid`, `openhaptics`, `haply`, or `none` if Tactus does not support the device
  bool simulated = false;
  bool usable = false;
  std::string reason;                            ///< why the device cannot be used
  std::string advice;                            ///< what to do to use it, or to calibrate it
  std::optional<bool> calibrated;                ///< nothing: unknown
  std::string used_by;                           ///< another program that has it open; empty: none is known
  std::optional<double> round_trip_s;            ///< measured: from a command to its reply
  std::optional<double> largest_stiffness_n_mm;  ///< what the servo renders at most with it; if measured
};

struct DeviceList {
  std::vector<ListedDevice> devices;  ///< the virtual device is always the last one
  std::vector<std::string> notes;     ///< parts of the search that failed
};

/// The result of the OpenHaptics search.
struct OpenHapticsLook {
  std::optional<haptics::DeviceInfo> info;  ///< the default device, if it opens
  bool calibrated = false;
  std::string calibration_advice;
  std::string reason;  ///< why there is none
  std::string advice;
};
/// Loads the library, opens the default device and closes it again. The device does not move.
OpenHapticsLook lookAtOpenHaptics(const std::string& hd_library);

using HaplyLook = base::Result<std::vector<haptics::HaplyFound>>;

/// Makes the list from the search results. A Touch on USB and the device of OpenHaptics are one device.
DeviceList listOf(const std::vector<haptics::HidDevice>& hid, const OpenHapticsLook& openhaptics,
                  const HaplyLook& haply, const std::vector<haptics::DeviceCalibration>& calibrations);

/// Searches for devices on this computer.
DeviceList listDevices(const DeviceSettings& settings);

/// Opens a haptic device by its id in the list of devices.
struct OpenedDevice {
  std::unique_ptr<haptics::HapticDevice> device;  ///< not started
  haptics::AxisMapping axis;                      ///< direction of the insertion axis; from the calibration if there is
                                                  ///< one
  std::string calibration_advice;                 ///< what to do if the device reports that it is not calibrated
  std::string axis_advice;  ///< what to do if inward and outward are swapped; empty: the axis is the device's own
};

/// Opens `virtual`, `hid:VVVV:PPPP[:SERIAL]`, `openhaptics[:NAME]`, `haply` for the first Haply device,
/// `haply:ID` or `simulated-haply:ID`. Refused, with advice: an invalid id, a device
/// that is missing or cannot be opened, a calibration file that cannot be read.
base::Result<OpenedDevice> open(const std::string& id, const DeviceSettings& settings);

/// Whether the driver of the device calibrates it, so that its file of calibrations has its axis alone.
bool hasOwnCalibration(const std::string& id);

/// How to reverse the insertion axis of a device that its driver calibrates.
std::string turnAxisAdvice(const std::string& id, const haptics::Vector3& inwards);

/// `x,y,z` with at most four digits, the format of `--inwards`.
std::string directionText(const haptics::Vector3& direction);

/// A HID device without its calibration: positions are counts, and 1 N is full scale. For calibrating it.
base::Result<OpenedDevice> openRaw(const std::string& id);

}  // namespace tactus::devices
