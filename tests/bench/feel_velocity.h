// How wrong the force becomes because speeds come from counted positions, for each velocity estimator and filter.
#pragma once

#include "tests/bench/feel_results.h"

namespace tactus::bench {

/// `rounds` turns of each estimator for what it costs.
FeelPart measureVelocityEstimators(int rounds);

}  // namespace tactus::bench
