// The numbers on an axis over a universe: round numbers and both ends.
#pragma once

#include <vector>

namespace tactus::workbench {

/// About `count` >= 1 round numbers between `min` and `max`, ascending, and both ends. A round number that would
/// overlap an end is left out. `count` = 1 gives the ends alone.
std::vector<double> universeTicks(double min, double max, int count);

}  // namespace tactus::workbench
