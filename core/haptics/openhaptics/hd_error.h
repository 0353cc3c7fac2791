// The errors of the HD library, sorted by their effect on the force.
#pragma once

#include <string>

#include "core/haptics/device/device.h"
#include "core/haptics/openhaptics/hd_api.h"

namespace tactus::haptics {

/// The fault for one error code. Warm motors and refused forces keep the loop running without force. A lost connection,
/// a dead timer and broken frames end it. Real-time safe: yes.
DeviceFault faultOf(std::uint32_t code) noexcept;
/// Whether the driver's loop cannot continue after this error. Real-time safe: yes.
bool endsLoop(std::uint32_t code) noexcept;

/// All errors that were on the stack.
struct HdErrors {
  int count = 0;
  HdErrorRecord newest;                    ///< the library returns the newest first
  HdErrorRecord gravest;                   ///< the error that determines `fault`
  DeviceFault fault = DeviceFault::kNone;  ///< kLost if one of the errors ends the loop

  bool endsLoop() const noexcept { return fault == DeviceFault::kLost; }
};

/// Empties the error stack. Stops after 64 errors, in case the library never reports "no error". Real-time safe: yes.
HdErrors drainErrors(const HdApi& api) noexcept;

/// A phrase about `error` with the library's own words, e.g. `the motors are too warm (0x0200, internal 7, "...")`.
std::string describe(const HdApi& api, const HdErrorRecord& error);

}  // namespace tactus::haptics
