// What a haptic device would record of a simulated hand. Not a measurement of anybody.
#pragma once

#include <span>
#include <vector>

#include "core/base/random.h"

namespace tactus::session {

/// What sets one recording apart from another of the same movement.
struct RecordingNoise {
  std::vector<double> tremor_mm;  ///< one per tick: physiological tremor, a sine of 8 to 12 Hz
  std::vector<bool> missed;       ///< one per tick: the device's sample was lost

  /// Draws them for a recording of `ticks` samples at 1 kHz: a tremor of 0.1 mm, the least of what is usual, and about
  /// one sample in a thousand lost, never the first or the last.
  static RecordingNoise of(std::size_t ticks, base::Random& random);
};

/// Positions with their time stamps, as they come from a device.
struct Recording {
  std::vector<double> time_s;  ///< from 0
  std::vector<double> depth_mm;
};

/// Records the hand that moves with `speeds_mm_s` (one per tick of 1 ms, not all 0): the depth is their integral, plus
/// the tremor, which comes and goes with the movement, in steps of the 0.055 mm that a desktop device tells apart. The
/// hand starts `offset` (0 to 1) of a step above a step of the device, so that the depth starts at 0 or one step above.
Recording record(std::span<const double> speeds_mm_s, const RecordingNoise& noise, double offset);

}  // namespace tactus::session
