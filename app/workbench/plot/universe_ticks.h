// The numbers at an axis over a universe: round ones and both ends.
#pragma once

#include <vector>

namespace tactus::workbench {

/// About `count` round numbers between `min` and `max`, ascending, and both ends; a round number too near to an end
/// would print over it and is left out. `count` of at least 1; only the ends where `count` is 1.
std::vector<double> universeTicks(double min, double max, int count);

}  // namespace tactus::workbench
