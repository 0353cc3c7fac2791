// Whether the rules of an expert can be used with the terms of the model, and whether they contradict each other.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/rules/expert_rules.h"

namespace tactus::elicitation {

/// Checks the rules of `expert` against the terms that they are to use; `origin` says where they come from. Refused,
/// with the line of the table or the number of the rule: an unknown input or term, a weight outside [0, 1], the same
/// rule twice. `absent_output_terms` have an error of their own.
base::Result<void> checkRules(const fuzzy::Expert& expert, const ExpertRules& origin,
                              std::span<const fuzzy::Variable> inputs, const fuzzy::Variable& output,
                              std::span<const std::string> absent_output_terms);

/// A sentence about the rules that have the conditions of an earlier rule and another consequent, if there are any.
/// Both stay in the model.
std::optional<std::string> contradictionNote(const ExpertRules& expert);

}  // namespace tactus::elicitation
