// What one tick of the renderer and of the servo costs, beside one evaluation of fuzzylite.
#pragma once

#include "tests/bench/feel_results.h"

namespace tactus::bench {

/// `rounds` turns of each.
FeelPart measureTicks(int rounds);

}  // namespace tactus::bench
