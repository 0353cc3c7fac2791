// The recording that a haptic device would make of a simulated hand. It is not a measurement.
#pragma once

#include <span>
#include <vector>

#include "core/base/random.h"

namespace tactus::session {

inline constexpr double kSimulatedRateHz = 1000;  ///< of the samples: the rate of the servo
inline constexpr double kTremorMm = 0.1;          ///< amplitude, the low end of physiological tremor

/// The random part of a recording. Two recordings of one movement differ only in it.
struct RecordingNoise {
  std::vector<double> tremor_mm;  ///< one per tick: physiological tremor, a sine of 8 to 12 Hz
  std::vector<bool> missed;       ///< one per tick: the device lost its sample

  /// Draws the noise for a recording of `ticks` samples at 1 kHz: a tremor of 0.1 mm, the low end of the usual range,
  /// and about one lost sample in a thousand, never the first or the last.
  static RecordingNoise of(std::size_t ticks, base::Random& random);
};

/// Positions and their times, as a device delivers them.
struct Recording {
  std::vector<double> time_s;  ///< from 0
  std::vector<double> depth_mm;
};

/// Records a hand that moves with `speeds_mm_s` (one per tick of 1 ms, not all 0). The depth is their integral plus the
/// tremor, which grows and fades with the movement, in steps of 0.055 mm, the resolution of a desktop device. The hand
/// starts `offset` (0 to 1) of a step above a device step, so the depth starts at 0 or one step above.
Recording record(std::span<const double> speeds_mm_s, const RecordingNoise& noise, double offset);

}  // namespace tactus::session
