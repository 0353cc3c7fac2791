// The commands of `tactus devices`. Two of them hold a dialog with the person at the device.
#pragma once

#include <iosfwd>
#include <string>

#include "app/cli/commands.h"

namespace tactus::cli {

/// The streams of the dialog. Both outlive the command.
struct Terminal {
  std::istream* in = nullptr;
  std::ostream* out = nullptr;
};

struct DevicesOptions {
  bool json = false;
};
/// Lists the connected devices, with the reason if one cannot be used.
base::Result<Output> devices(const DevicesOptions& options);

struct DeviceTestOptions {
  std::string id;  ///< empty: the first usable device; hardware before the virtual device
  Terminal terminal;
  bool json = false;
  std::ostream* results = nullptr;  ///< stream for the JSON of a failed test
};
/// Runs the guided self-test. A failed check is an error.
base::Result<Output> testDevice(const DeviceTestOptions& options);

struct DeviceCalibrateOptions {
  std::string id;
  std::string method = "spring";  ///< `spring` or `weight`
  std::string inwards;            ///< `x,y,z`: only stores this insertion axis; empty: calibrates
  Terminal terminal;
};
/// Runs the guided calibration of a HID device and stores the result for this computer. Or stores the insertion axis of
/// an OpenHaptics device.
base::Result<Output> calibrateDevice(const DeviceCalibrateOptions& options);

}  // namespace tactus::cli
