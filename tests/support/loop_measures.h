// What a hand would feel of a simulated loop, in numbers.
#pragma once

#include <vector>

#include "tests/support/simulated_loop.h"

namespace tactus::support {

/// The lowest value of the energy that the force has taken from the hand so far, mJ. Below 0 the force has been active.
double lowestEnergyMj(const std::vector<LoopTick>& ticks);
double largestStepN(const std::vector<LoopTick>& ticks);
/// Root mean square of the force above 30 Hz (second-order Butterworth).
double rippleN(const std::vector<LoopTick>& ticks);
/// Root mean square of the speed during the last half second, mm/s.
double lastSpeedMmS(const std::vector<LoopTick>& ticks);

}  // namespace tactus::support
