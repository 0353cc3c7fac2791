// What the scene economy saves in a whole placement: asking only when needed, and a model specialized to what is fixed.
#pragma once

#include "tests/bench/feel_results.h"

namespace tactus::bench {

/// `rounds` turns of each way.
FeelPart measureEconomy(int rounds);

}  // namespace tactus::bench
