// The fixes of a lint finding: edits that settle it with one click, each with its effect in newtons.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "app/editing/edit.h"
#include "app/editing/edit_impact.h"
#include "core/analysis/lint.h"
#include "elicitation/rules/rule_finding.h"

namespace tactus::editing {

struct Fix {
  std::string text;   ///< text of the button: `Stretch Laryngopharynx over the gap`
  Edit edit;          ///< for EditHistory::apply
  EditImpact impact;  ///< effect of the edit on the averaged force
};

/// The fixes of `finding`, found in this same `model` (valid; `compiled` is made from it). Empty if only a person can
/// decide. The function decides nothing: the researcher chooses a fix, ideally together with the expert.
///   hole                stretch the term of either side over the gap, or accept the hole (hole_fixes.h); for an
///                       accepted hole: stretch, or withdraw the acceptance
///   abstention jump     the fixes of the expert's hole behind it
///   force step          widen the flanks at the step (step_fixes.h)
///   conflict            disable one of the two rules, or the other
///   redundant rule, unreachable rule    disable it
///   unused or unreachable term          remove it; if the terms sum to one, also with the neighbors closing the gap
/// Returns soon after `stop` is requested; the result is then incomplete and must not be used.
std::vector<Fix> fixesFor(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                          const analysis::Finding& finding, const std::stop_token& stop = {});
/// The same for a finding of the rule lint. A region without a rule is treated as an unused term with the hole that it
/// leaves. Other kinds that the model's own lint does not know have no fix.
std::vector<Fix> fixesFor(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                          const elicitation::RuleFinding& finding, const std::stop_token& stop = {});

}  // namespace tactus::editing
