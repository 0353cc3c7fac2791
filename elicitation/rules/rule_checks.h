// Checks the rules of an expert against the terms of the model, and for contradictions.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/rules/expert_rules.h"

namespace tactus::elicitation {

/// Checks the rules of `expert` against the terms for them. `origin`: the source of the rules. Returns an error with
/// the table line or rule number for: an unknown input or term, a weight outside [0, 1], a duplicate rule. Terms in
/// `absent_output_terms` have their own error.
base::Result<void> checkRules(const fuzzy::Expert& expert, const ExpertRules& origin,
                              std::span<const fuzzy::Variable> inputs, const fuzzy::Variable& output,
                              std::span<const std::string> absent_output_terms);

/// A sentence about rules with the conditions of an earlier rule and another consequent; nothing if there are none.
/// Both rules stay in the model.
std::optional<std::string> contradictionNote(const ExpertRules& expert);

}  // namespace tactus::elicitation
