// Simulated insertion strokes whose speeds have a given mean and standard deviation. Not a measurement of anybody.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/study/records.h"
#include "experiments/published_tables.h"

namespace tactus::session {

/// Strokes of the speed experiment (paper, Section 3.1.4) for each cell of `targets`: four strokes of about 60 mm, each
/// a recording of positions at 1 kHz (simulated_recording.h), from which the speeds are computed in the way of a real
/// one (experiments/speed_from_positions.h); the forward part is kept. A hand goes from rest over a ramp (minimum-jerk
/// in the speed) to a plateau and back, with a slow wander of a few percent and a duration of its own. Time starts at 0
/// in each forward part, depth where the hand came from rest; time, depth and speed are rounded to 0.001. The length of
/// the ramps sets the standard deviation (n - 1, over all samples of the cell); it and the mean are met to 0.01 mm/s.
/// The targets must be like those of Table 1: means of 30 to 300 mm/s, standard deviations of 0.23 to 0.52 of the mean.
/// The same `seed` gives the same strokes; a cell's strokes depend on the seed and on its place in `targets` only.
std::vector<study::SpeedSample> simulatedStrokes(std::span<const experiments::PublishedSpeed> targets,
                                                 std::uint64_t seed);

}  // namespace tactus::session
