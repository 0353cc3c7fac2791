// A look-up table of a model: forces on a grid, linear between its lines in every input.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::bundle {

struct ForceTable {
  std::vector<std::vector<double>> lines;  ///< of each input, ascending; the last input runs fastest
  std::vector<double> force_n;             ///< one per node

  /// The interpolated force; values outside the grid are clamped.
  double force(std::span<const double> point) const;
};

inline constexpr std::size_t kMostNodes = 100'000;

/// The finest grid of at most `most_nodes` nodes. Its lines are the ends of the universes, the vertices of the terms,
/// and equally many further lines between any two neighbors. If the vertices alone need more nodes, some of them are
/// left out. A node where no rule fires has the default force.
ForceTable forceTable(const fuzzy::ForceModel& model, std::size_t most_nodes = kMostNodes);

/// `id,…,force`, one row per node.
std::string formatTable(const fuzzy::ForceModel& model, const ForceTable& table);
/// Reads the text back. Refused: a node missing, doubled or out of order.
base::Result<ForceTable> parseTable(const fuzzy::ForceModel& model, std::string text, const std::string& file);

}  // namespace tactus::bundle
