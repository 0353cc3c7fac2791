// Detects silence of the device, the writes and the servo, and gives its consequence.
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

/// The trip that these ages require, or none; a late servo comes first. The caller sets `time_ns`. Real-time safe: yes.
Trip overdue(const Ages& ages, const LimitSettings& limits) noexcept;

/// The remaining share of a force if the device's sample is `age_s` old: 1 up to `stale_decay_s`, 0 from `stale_zero_s`
/// on. Between them it decays exponentially with a time constant of 10 ms, shifted down so that it ends at 0 without a
/// step.
double staleShare(double age_s, const LimitSettings& limits) noexcept;

}  // namespace tactus::haptics
