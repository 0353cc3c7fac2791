// Haptic devices that are not force-feedback HID devices, by their USB ids, and what to do with them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace tactus::haptics {

struct KnownDevice {
  std::string_view name;
  std::string_view advice;         ///< why it is no PID device, and what to do; one or two sentences
  bool game_devices_only = false;  ///< the maker sells mice and the like too: true of joysticks and wheels alone
};

/// A device that cannot be reached through HID PID, or nothing. Some of these are no HID devices at all.
std::optional<KnownDevice> knownDevice(std::uint16_t vendor, std::uint16_t product) noexcept;

}  // namespace tactus::haptics
