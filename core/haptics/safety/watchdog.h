// Who has been silent for how long, and what follows.
#pragma once

#include <cstdint>

#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/safety/trip.h"

namespace tactus::haptics {

/// Ages at a tick, s.
struct Ages {
  double sample_s = 0;  ///< of the device's newest sample
  double write_s = 0;   ///< since a force last reached the device
  double gap_s = 0;     ///< since the last tick
};

/// The trip that these ages call for, the servo's own first; `time_ns` is left to the caller. Real-time safe: yes.
Trip overdue(const Ages& ages, const LimitSettings& limits) noexcept;

/// What is left of a force when the device's sample is `age_s` old: 1 up to `stale_decay_s`, 0 from `stale_zero_s`, in
/// between an exponential decay with a time constant of 10 ms, shifted down so that it ends at 0 without a step.
/// Real-time safe: yes.
double staleShare(double age_s, const LimitSettings& limits) noexcept;

}  // namespace tactus::haptics
