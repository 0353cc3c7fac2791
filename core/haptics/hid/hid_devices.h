// The HID devices of this computer that have to do with forces, and why one of them cannot be used.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/hid/hid_pid_device.h"
#include "core/haptics/hid/node_lock.h"

namespace tactus::haptics {

enum class HidDeviceKind : std::uint8_t {
  kPid,    ///< force feedback by HID PID
  kKnown,  ///< a haptic device that needs something else
  kOther,  ///< a mouse, a keyboard, …
};

struct HidDevice {
  std::string path;  ///< what HidapiTransport::open wants; empty for a device that is no HID device
  HidIdentity identity;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  HidDeviceKind kind = HidDeviceKind::kOther;
  std::string problem;  ///< why it cannot be used now; empty: it can
  std::string advice;   ///< what to do about it
  std::string used_by;  ///< another program that has it open, e.g. `tactus (process 4711)`; empty: none that is known
};

/// The id of a device: `hid:1209:ffb0`, with `:serial` where there is one.
std::string hidDeviceId(std::uint16_t vendor, std::uint16_t product, const std::string& serial);

/// Fills `kind`, `problem` and `advice` in: PID by its descriptor, whatever the ids are; others by their ids.
void judge(HidDevice& device, const base::Result<std::vector<std::uint8_t>>& descriptor, bool may_open);

/// The product name, in UTF-8, that the kernel has for the node `path` (`/dev/hidraw3`), whatever the locale is: that
/// of the USB device, or else that of the HID device. Empty where there is none.
std::string nameOfNode(const std::string& path, const std::string& system_folder = "/sys/class/hidraw");
/// The serial number, likewise.
std::string serialOfNode(const std::string& path, const std::string& system_folder = "/sys/class/hidraw");

/// A device that could be used is in use by `holder`. This program's own hold is no problem.
void noteHolder(HidDevice& device, const std::optional<NodeHolder>& holder);

/// Each node once, though hidapi lists one entry per collection. kOther is left out unless `all`. At the end come known
/// haptic devices on USB that are no HID devices. Thread: one at a time (hidapi).
std::vector<HidDevice> listHidDevices(bool all = false);

/// Known haptic devices among the USB devices under `folder` (/sys/bus/usb/devices). A folder that cannot be read has
/// none.
std::vector<HidDevice> knownUsbDevices(const std::string& folder);

}  // namespace tactus::haptics
