// How far a look-up table can be off anywhere in the box of the inputs: a bound, not a sample.
#pragma once

#include <stop_token>
#include <vector>

#include "app/bundle/force_table.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::bundle {

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

}  // namespace tactus::bundle
