// A term split into parts, as the paper proposes for its esophagus (Section 6): rules are copied to the parts.
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
  std::vector<double> cuts;  ///< ascending, inside the core, in the unit of the variable; one more part than cuts
  /// Width of the ramps at the cuts. Nothing: the mean of the term's own ramps (where it has none, a hundredth of the
  /// universe), at most half of the shortest piece of the core.
  std::optional<double> overlap;
  std::vector<TermName> names;  ///< one for each part; empty: `esophagus_1`, `Esophagus 1` and so on
  bool copy_rules = true;       ///< otherwise the rules stay with the part that holds the middle of the core
};

/// Splits a trapezoid. The parts overlap around each cut so that together they are the term as it was: terms that
/// summed to one still do. Each rule with the term in a condition becomes one rule for each part, in their order and at
/// its place, so the force between the overlaps stays as it was. Consequents are never copied, since two of them would
/// conflict: the rules of an output term stay with the part that holds the middle of its core.
/// Refused: a triangle or Gaussian (convert it first), cuts or an overlap that leave the core.
base::Result<Edit> splitTerm(const fuzzy::ForceModel& model, const TermPlace& place, const SplitOptions& options);

}  // namespace tactus::editing
