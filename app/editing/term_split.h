// Splits a term into parts, as the paper proposes for its esophagus (Section 6), and copies its rules to the parts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editing/term_list.h"

namespace tactus::editing {

struct TermName {
  std::string id;
  std::string label;
};

struct SplitOptions {
  std::vector<double> cuts;  ///< ascending, inside the core, in the unit of the variable; n cuts make n + 1 parts
  /// Width of the ramps at the cuts. Nothing: the mean of the term's own ramps (without ramps 1/100 of the universe),
  /// but at most half of the shortest piece of the core.
  std::optional<double> overlap;
  std::vector<TermName> names;  ///< one per part; empty: `esophagus_1`, `Esophagus 1` and so on
  bool copy_rules = true;       ///< false: the rules stay with the part that holds the middle of the core
};

/// Splits a trapezoid. The parts overlap around each cut so that their sum is the old term; a partition stays a
/// partition. A rule with the term in a condition becomes one rule for each part, in their order and at its place, so
/// the force outside the overlaps does not change. Consequents are never copied, because the copies would conflict: the
/// rules of an output term stay with the part that holds the middle of its core. Refused: a triangle or Gaussian
/// (convert it first), cuts or an overlap outside the core.
base::Result<Edit> splitTerm(const fuzzy::ForceModel& model, const TermPlace& place, const SplitOptions& options);

}  // namespace tactus::editing
