// Haptic devices without HID force feedback, listed by USB ids, with advice for each.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace tactus::haptics {

struct KnownDevice {
  std::string_view name;
  std::string_view advice;         ///< the reason why it is not a PID device, and the remedy; one or two sentences
  bool game_devices_only = false;  ///< the manufacturer also sells mice etc.: match joysticks and wheels only
};

/// The entry of a device that HID PID cannot reach, or nothing. Some of these are not HID devices at all.
std::optional<KnownDevice> knownDevice(std::uint16_t vendor, std::uint16_t product) noexcept;

}  // namespace tactus::haptics
