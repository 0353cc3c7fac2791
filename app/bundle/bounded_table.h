// The coarsest look-up table that is proved to be within a wanted error.
#pragma once

#include <cstddef>
#include <stop_token>

#include "app/bundle/table_bound.h"

namespace tactus::bundle {

inline constexpr double kTableErrorN = 0.01;
inline constexpr std::size_t kMostNodes = 2'000'000;

struct BoundedTable {
  ForceTable table;
  TableBound bound;
};

/// A table that is nowhere further off than `wanted_n` (> 0): lines at the vertices of the terms, and as many even
/// steps between two of them as they need. If that takes more than `most_nodes`, the finest that fits; its bound says
/// so. The nodes do not hold the force itself but what spreads the error evenly to both sides (at most `wanted_n` off),
/// which halves it. A table of a force that jumps is off by the jump beside it, whatever the grid; it stays small. A
/// request to stop ends it with any table.
BoundedTable boundedTable(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                          double wanted_n = kTableErrorN, std::size_t most_nodes = kMostNodes,
                          const std::stop_token& stop = {});

}  // namespace tactus::bundle
