// The limits that acted in a tick.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace tactus::haptics {

/// Bits of Sample::limited and LimitedForce::limited.
enum LimitBit : std::uint32_t {
  kLimitedByCap = 1u << 0,
  kLimitedBySlew = 1u << 1,
  kLimitedByFadeIn = 1u << 2,
  kLimitedByThermal = 1u << 3,
  kLimitedByPassivity = 1u << 4,
  kLimitedByStaleDevice = 1u << 5,
  kLimitedByGui = 1u << 6,
  kLimitedByRelease = 1u << 7,  ///< the hand has not enabled the force
  kLimitedByTrip = 1u << 8,
  kLimitedByStiffness = 1u << 9,  ///< the rendered stiffness is below the model's
  kLimitedByGap = 1u << 10,       ///< fade-in after a gap between commands longer than the device holds a force
};

/// Names of the bits in traces and reports, bit 0 first.
inline constexpr std::array<std::string_view, 11> kLimitNames = {
    "cap",     "slew", "fade_in",   "thermal",    "passivity", "stale_device", "program_silent",
    "release", "trip", "stiffness", "command_gap"};

}  // namespace tactus::haptics
