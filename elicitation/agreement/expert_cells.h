// The cells of a model's experts: conditions that their rules name, and who has a rule there.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::elicitation {

/// One expert's rule in a cell, with the memberships of its conditions.
struct CellRule {
  std::size_t rule = 0;
  std::vector<std::pair<std::size_t, fuzzy::MembershipFunction>> memberships;  ///< by input

  /// Whether the rule has a strength > 0 at `point`.
  bool fires(const fuzzy::ForceModel& model, const std::vector<double>& point) const;
};

struct ExpertCell {
  std::vector<fuzzy::Condition> conditions;
  std::vector<std::optional<CellRule>> rules;  ///< per expert, in the model's order
};

/// The conditions of a rule as input and term, sorted: the same conditions in another order are the same cell.
std::vector<std::pair<std::string, std::string>> cellKey(const fuzzy::Rule& rule);

/// The cells of a valid model, in the order in which the experts' rules name them. Only rules that can fire count. Of
/// several rules of one expert with the same conditions the first stands for the cell; the lint names the conflict.
std::vector<ExpertCell> expertCells(const fuzzy::ForceModel& model);

}  // namespace tactus::elicitation
