// Simulated insertion strokes whose speeds have a given mean and standard deviation. Not a measurement of anybody.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/study/records.h"
#include "experiments/published_tables.h"

namespace tactus::session {

/// Strokes of the speed experiment (paper, Section 3.1.4) for each cell of `targets`: four strokes of 60 mm (to 0.1
/// mm), sampled at 1 kHz. Each goes from rest over a ramp (minimum-jerk in the speed) to a plateau and back, with a
/// slow wander of a few percent and a duration of its own. Time and depth start at 0 in each stroke; depth is the
/// integral of speed; both are rounded to 0.001. The length of the ramps sets the standard deviation (n - 1, over all
/// samples of the cell); it and the mean are met to 0.01 mm/s. A target's standard deviation must be between 0.15 and
/// 0.7 of its mean, its mean at most 500 mm/s. The same `seed` gives the same strokes; a cell's strokes depend on the
/// seed and on its place in `targets` only.
std::vector<study::SpeedSample> simulatedStrokes(std::span<const experiments::PublishedSpeed> targets,
                                                 std::uint64_t seed);

}  // namespace tactus::session
