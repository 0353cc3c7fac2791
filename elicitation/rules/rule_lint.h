// Findings about the rules of a model, using the study's data: items, table lines, declared directions.
#pragma once

#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/analysis/lint.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/rules/expert_rules.h"
#include "elicitation/rules/rule_finding.h"
#include "elicitation/variables/ngt_variables.h"

namespace tactus::elicitation {

/// The study's declared directions and the limits for findings. Inputs that the model lacks are ignored.
struct RuleLintSettings {
  std::vector<DeclaredDirection> directions = ngtDirections();
  std::string region_input = ngtRegionInput();  ///< empty: no regions
  int jump_levels = 3;                          ///< levels between neighboring answers that make a finding
  double noticeable_times = 2;                  ///< just-noticeable differences between experts that make a finding
};

struct RuleLint {
  std::vector<RuleFinding>
      findings;                  ///< by kind in the order of RuleFinding::Kind, within a kind the largest newtons first
  analysis::Lint model;          ///< reachable range, bounds, completeness; `findings` includes its findings
  bool newtons_complete = true;  ///< false if the budget for forces was used up (huge model)
};

/// All findings about `model`, which must be valid. `compiled`: made from it. `origins`: one per expert in the model's
/// order (BuiltModel::experts), or none if only the model is known; then there are no missing items, and rules are
/// named by number. Experts are compared only if the force is in N. Ends soon after `stop` is requested; the result is
/// then invalid.
RuleLint ruleLint(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                  std::span<const ExpertRules> origins = {}, const RuleLintSettings& settings = {},
                  const std::stop_token& stop = {});

}  // namespace tactus::elicitation
