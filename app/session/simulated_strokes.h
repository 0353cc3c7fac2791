// Simulated insertion strokes whose speeds have a given mean and standard deviation. They are not measurements.
#pragma once

#include <cstdint>
#include <vector>

#include "app/session/simulated_recording.h"
#include "experiments/published_tables.h"

namespace tactus::session {

/// The samples of a device while one person does one level of the speed experiment (paper, Section 3.1.4), stroke by
/// stroke: rest, the stroke, a pause, the way back, rest.
struct SimulatedLevel {
  std::vector<Recording> strokes;   ///< four accepted strokes; their speeds have the level's mean and deviation
  std::vector<Recording> practice;  ///< two accepted strokes
  Recording too_short;              ///< the hand stops after 18 mm
};

/// A level for the mean and standard deviation of `target`. A stroke is about 60 mm long: from rest over a ramp
/// (minimum-jerk in the speed) to a plateau and back, with a slow wander of a few percent and its own duration. A
/// device records it (simulated_recording.h). The scored speeds are those of a real stroke: between the ends that the
/// segmentation finds with its default settings, from the recorded positions (experiments/stroke_speeds.h). The length
/// of the ramps sets the standard deviation (n - 1, over all samples of the four). Mean and deviation are met to 0.04
/// mm/s. `target` must be in the range of Table 1: means of 30 to 300 mm/s, standard deviations of 0.23 to 0.52 of the
/// mean. The same `seed` gives the same level.
SimulatedLevel simulatedLevel(const experiments::PublishedSpeed& target, std::uint64_t seed);

}  // namespace tactus::session
