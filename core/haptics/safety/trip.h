// A trip: the force goes to zero and stays there until the user arms again.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tactus::haptics {

enum class TripCause : std::uint8_t {
  kNone,
  kForceNotFinite,     ///< a force source returned NaN or infinity; value: 0
  kPositionNotFinite,  ///< value: 0
  kTooFastInwards,     ///< value: mm/s
  kTooFastOutwards,    ///< value: mm/s
  kDeviceSilent,       ///< no sample; value: age in s
  kWriteStuck,         ///< no force reached the device; value: age in s
  kServoLate,          ///< ticks were missed; value: gap in s
  kDeviceLost,         ///< unplugged
  kDeviceFault,        ///< value: the DeviceFault
  kRenderer,           ///< the renderer released the force; value: the render::Fault
  kStopped,            ///< the user pressed Stop
};

struct Trip {
  TripCause cause = TripCause::kNone;
  double value = 0;          ///< the value found, in the unit of the cause
  double limit = 0;          ///< the allowed value, in the same unit; 0 if there is no limit
  std::int64_t time_ns = 0;  ///< of the tick

  explicit operator bool() const noexcept { return cause != TripCause::kNone; }
  bool operator==(const Trip&) const = default;
};

/// The cause in words for the user, e.g. `the hand moved outwards too fast`.
std::string_view describe(TripCause cause) noexcept;
/// Unit of value and limit, e.g. `mm/s`; empty if there is none.
std::string_view unitOf(TripCause cause) noexcept;
/// Cause, value and limit on one line, e.g. `the hand moved outwards too fast: 431 mm/s, allowed 400 mm/s`. A fault of
/// device or renderer appears in words, e.g. `the motors are too warm`. Each number has its unit. Real-time safe: no.
std::string sentence(const Trip& trip);

}  // namespace tactus::haptics
