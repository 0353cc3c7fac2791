// The HID devices of this computer with force feedback, and the reason if one cannot be used.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/hid/hid_pid_device.h"
#include "core/haptics/hid/hidapi_transport.h"

namespace tactus::haptics {

/// Haptic devices without HID force feedback, listed by USB ids, with advice for each.
struct KnownDevice {
  std::string_view name;
  std::string_view advice;         ///< the reason why it is not a PID device, and the remedy; one or two sentences
  bool game_devices_only = false;  ///< the manufacturer also sells mice etc.: match joysticks and wheels only
};

/// The entry of a device that HID PID cannot reach, or nothing. Some of these are not HID devices at all.
std::optional<KnownDevice> knownDevice(std::uint16_t vendor, std::uint16_t product) noexcept;

enum class HidDeviceKind : std::uint8_t {
  kPid,    ///< force feedback by HID PID
  kKnown,  ///< a haptic device that needs another driver
  kOther,  ///< a mouse, a keyboard, …
};

struct HidDevice {
  std::string path;  ///< the argument of HidapiTransport::open; empty if the device is not a HID device
  HidIdentity identity;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  HidDeviceKind kind = HidDeviceKind::kOther;
  std::string problem;  ///< the reason why it cannot be used now; empty if it can
  std::string advice;   ///< the remedy
  std::string used_by;  ///< another program that has it open, e.g. `tactus (process 4711)`; empty if none is known
};

/// The id of a device: `hid:1209:ffb0`, followed by `:serial` if there is a serial number.
std::string hidDeviceId(std::uint16_t vendor, std::uint16_t product, const std::string& serial);

/// Fills in `kind`, `problem` and `advice`. The descriptor identifies a PID device, regardless of its ids. The ids
/// identify other devices.
void judge(HidDevice& device, const base::Result<std::vector<std::uint8_t>>& descriptor, bool may_open);

/// The product name, in UTF-8, that the kernel stores for the node `path` (`/dev/hidraw3`), in any locale. It is the
/// name of the USB device, or else of the HID device. Empty if there is none.
std::string nameOfNode(const std::string& path, const std::string& system_folder = "/sys/class/hidraw");
/// The serial number of the node, in the same way.
std::string serialOfNode(const std::string& path, const std::string& system_folder = "/sys/class/hidraw");

/// Marks a usable device as in use by `holder`. No effect if this program is the holder.
void noteHolder(HidDevice& device, const std::optional<NodeHolder>& holder);

/// Lists each node once, although hidapi lists one entry per collection. Leaves out kOther unless `all`. The last
/// entries are known haptic devices on USB that are not HID devices. Thread: one at a time (hidapi).
std::vector<HidDevice> listHidDevices(bool all = false);

/// The known haptic devices among the USB devices under `folder` (/sys/bus/usb/devices). Empty if the folder cannot be
/// read.
std::vector<HidDevice> knownUsbDevices(const std::string& folder);

}  // namespace tactus::haptics
