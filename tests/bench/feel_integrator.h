// Step of the integration against its error and its cost, for the simulated hands.
#pragma once

#include "tests/bench/feel_results.h"

namespace tactus::bench {

/// `rounds` turns of each step for what it costs.
FeelPart measureIntegrator(int rounds);

}  // namespace tactus::bench
