// One click for a finding of the lint: the edits that would settle it, each with the newtons that it changes.
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
  std::string text;   ///< of the button: `Stretch Laryngopharynx over the gap`
  Edit edit;          ///< to hand to EditHistory::apply
  EditImpact impact;  ///< of the edit on the averaged force
};

/// What can be done about `finding`, found in this very `model` (valid, `compiled` from it); empty where only a person
/// can tell. Nothing is decided here: the researcher picks one, best together with the expert.
///   hole                stretch the term of either side over the gap, or accept the hole (hole_fixes.h); one that is
///                       accepted: stretch, or take the acceptance back
///   abstention jump     those of the expert's hole behind it
///   force step          widen the flanks at the step (step_fixes.h)
///   conflict            keep the one rule, disable the other; either way round
///   redundant rule, unreachable rule    disable it
///   unused or unreachable term          remove it; where the terms sum to one also so that its neighbours close up
/// It ends soon after `stop` says so; what it has until then is of no use.
std::vector<Fix> fixesFor(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                          const analysis::Finding& finding, const std::stop_token& stop = {});
/// The same for a finding of the rule lint. A region without a rule is an unused term and the hole that it leaves;
/// the others that the model's own lint does not know have no fix.
std::vector<Fix> fixesFor(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                          const elicitation::RuleFinding& finding, const std::stop_token& stop = {});

}  // namespace tactus::editing
