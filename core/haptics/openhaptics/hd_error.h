// What the error stack of the HD library says, sorted by what it means for the hand.
#pragma once

#include <string>

#include "core/haptics/device/device.h"
#include "core/haptics/openhaptics/hd_api.h"

namespace tactus::haptics {

/// What one error code means: warm motors and refused forces leave the loop running without force; a lost connection,
/// a dead timer and broken frames end it.
/// Real-time safe: yes.
DeviceFault faultOf(std::uint32_t code) noexcept;
/// After these the driver's loop is not worth going on with. Real-time safe: yes.
bool endsLoop(std::uint32_t code) noexcept;

/// Everything that was on the stack.
struct HdErrors {
  int count = 0;
  HdErrorRecord newest;                    ///< the library hands out the newest first
  HdErrorRecord gravest;                   ///< the one that `fault` follows from
  DeviceFault fault = DeviceFault::kNone;  ///< kLost when one of them ends the loop

  bool endsLoop() const noexcept { return fault == DeviceFault::kLost; }
};

/// Empties the error stack. A library that never says "no error" is cut off after 64. Real-time safe: yes.
HdErrors drainErrors(const HdApi& api) noexcept;

/// One sentence part about `error`, with the library's own words, e.g. `the motors are too warm (0x0200, internal 7,
/// "...")`.
std::string describe(const HdApi& api, const HdErrorRecord& error);

}  // namespace tactus::haptics
