// The commands below `tactus devices`. Two of them talk with the person at the device.
#pragma once

#include <iosfwd>
#include <string>

#include "app/cli/commands.h"

namespace tactus::cli {

/// Where a command talks with a person while it runs. Both outlive the command.
struct Terminal {
  std::istream* in = nullptr;
  std::ostream* out = nullptr;
};

struct DevicesOptions {
  bool json = false;
};
/// What is attached, and why something cannot be used.
base::Result<Output> devices(const DevicesOptions& options);

struct DeviceTestOptions {
  std::string id;  ///< empty: the first usable device, hardware before the virtual one
  Terminal terminal;
  bool json = false;
  std::ostream* results = nullptr;  ///< where the JSON of a test goes that did not pass
};
/// The guided self-test. A check that fails is an error.
base::Result<Output> testDevice(const DeviceTestOptions& options);

struct DeviceCalibrateOptions {
  std::string id;
  std::string method = "spring";  ///< spring or weight
  std::string inwards;            ///< `x,y,z`: only store this insertion axis; empty: calibrate
  Terminal terminal;
};
/// The guided calibration of a HID device; what it measured is stored for this computer. Or the insertion axis of a
/// device behind OpenHaptics.
base::Result<Output> calibrateDevice(const DeviceCalibrateOptions& options);

}  // namespace tactus::cli
