// A look-up table of a model: forces on a grid, linear between its lines in every input.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::bundle {

struct ForceTable {
  std::vector<std::vector<double>> lines;  ///< of each input, ascending; the last input runs fastest
  std::vector<double> force_n;             ///< one per node

  /// The interpolated force; values outside the grid are clamped.
  double force(std::span<const double> point) const;
};

/// The ends of the universes and the vertices of all experts' terms between them, of each input, ascending. If they
/// alone make more than `most_nodes` nodes, some are left out.
std::vector<std::vector<double>> vertexLines(const fuzzy::ForceModel& model, std::size_t most_nodes);

/// The averaged force on the grid of `lines` (of each input, ascending, two or more). A node where no rule fires has
/// the default force.
ForceTable forceTable(const fuzzy::CompiledModel& compiled, std::vector<std::vector<double>> lines);

/// `id,…,force`, one row per node.
std::string formatTable(const fuzzy::ForceModel& model, const ForceTable& table);
/// Reads the text back. Refused: a node missing, doubled or out of order.
base::Result<ForceTable> parseTable(const fuzzy::ForceModel& model, std::string text, const std::string& file);

}  // namespace tactus::bundle
