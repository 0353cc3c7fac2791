// Simulated insertion strokes whose speeds have a given mean and standard deviation. They are not measurements.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/random.h"
#include "experiments/published_tables.h"

namespace tactus::session {

// The recording that a haptic device would make of a simulated hand. It is not a measurement.

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

/// The samples of a device while one person does one level of the speed experiment (paper, Section 3.1.4), stroke by
/// stroke: rest, the stroke, a pause, the way back, rest.
struct SimulatedLevel {
  std::vector<Recording> strokes;   ///< four accepted strokes; their speeds have the level's mean and deviation
  std::vector<Recording> practice;  ///< two accepted strokes
  Recording too_short;              ///< the hand stops after 18 mm
};

/// A level for the mean and standard deviation of `target`. A stroke is about 60 mm long: from rest over a ramp
/// (minimum-jerk in the speed) to a plateau and back, with a slow wander of a few percent and its own duration. A
/// device records it. The scored speeds are those of a real stroke: between the ends that the
/// segmentation finds with its default settings, from the recorded positions (experiments/stroke_speeds.h). The length
/// of the ramps sets the standard deviation (n - 1, over all samples of the four). Mean and deviation are met to 0.04
/// mm/s. `target` must be in the range of Table 1: means of 30 to 300 mm/s, standard deviations of 0.23 to 0.52 of the
/// mean. The same `seed` gives the same level.
SimulatedLevel simulatedLevel(const experiments::PublishedSpeed& target, std::uint64_t seed);

}  // namespace tactus::session
