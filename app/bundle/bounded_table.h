// The coarsest look-up table that is proved to be within a wanted error.
#pragma once

#include <cstddef>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::bundle {

// A look-up table of a model: forces on a grid, linear between its lines in every input.

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

// How far a look-up table can be off anywhere in the box of the inputs: a bound, not a sample.

/// What is known of a table after all its cells have been looked at.
struct TableBound {
  double bound_n = 0;  ///< the table is nowhere further off
  double found_n = 0;  ///< it is that far off somewhere; at most bound_n
  /// The force jumps, or has no value, in a cell or at its edge: no grid makes the error small there.
  bool jumps = false;
  /// For each input and each cell between its lines: how many times the bound is above the wanted error in cells there
  /// whose force bends along that input; 1 where it is not.
  std::vector<std::vector<double>> finer;
};

/// Bounds the error of `table` against the averaged force of the model. Cells that are proved to be off by at most
/// `wanted_n` are not looked at any closer; any other is bounded as sharply as a limited number of steps allows.
///
/// Branch and bound over each cell. In a box B let T be the table and I the force's interpolation between the corners
/// of B. T - I is linear in each input, so it is largest at a corner of B, where both are known. The error of I is at
/// most the sum over the inputs i of (M_i - m_i) h_i / 4, for a derivative by i within [m_i, M_i] and a width h_i:
/// interpolation in one input after the other, each an average, and in one variable the largest error of a line between
/// two values is that of a kink in the middle. The derivatives are enclosed by interval arithmetic: the rules that may
/// be the strongest, and what the strength of a term can move the centroid. Where an expert may abstain or a term has a
/// vertical edge, the force itself is enclosed instead. Deterministic, whatever the number of processors.
/// A request to stop ends it early; what it returns is then worth nothing.
TableBound tableBound(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, const ForceTable& table,
                      double wanted_n, const std::stop_token& stop = {});

inline constexpr double kTableErrorN = 0.01;

/// What a table of `model` may be off where nobody says otherwise: kTableErrorN; of a force universe beyond 1.25 N two
/// hundredths of it, which is below the just-noticeable difference of its upper half.
double usualTableErrorN(const fuzzy::ForceModel& model);
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
