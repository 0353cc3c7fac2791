// Maps of forces from a formula, for tests of what is drawn from them.
#pragma once

#include "app/workbench/understand/map/force_map.h"

namespace tactus::tests {

/// `force` of the shares x and y in [0, 1]; no rule fires where it is below 0.
template <class Force>
workbench::ForceMap sampleMap(std::size_t side, Force force) {
  workbench::ForceMap map;
  map.x_input = 0;
  map.y_input = 1;
  map.side = side;
  map.x_part = map.y_part = {0, 1};
  const auto last = static_cast<double>(side - 1);
  for (std::size_t y = 0; y < side; ++y) {
    for (std::size_t x = 0; x < side; ++x) {
      const double here = force(static_cast<double>(x) / last, static_cast<double>(y) / last);
      map.force_n.push_back(here < 0 ? 0 : here);
      map.fired.push_back(here < 0 ? 0 : 1);
    }
  }
  return map;
}

}  // namespace tactus::tests
