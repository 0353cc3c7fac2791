// Findings about the rules of a model, with what only the study knows: items, lines of tables, declared directions.
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

/// What a study declares and how far apart is too far. Inputs that the model does not have are passed over.
struct RuleLintSettings {
  std::vector<DeclaredDirection> directions = ngtDirections();
  std::string region_input = ngtRegionInput();  ///< empty: no regions
  int jump_levels = 3;                          ///< levels between neighbouring answers that make a finding
  double noticeable_times = 2;                  ///< just-noticeable differences between experts that make a finding
};

struct RuleLint {
  std::vector<RuleFinding>
      findings;                  ///< by kind in the order of RuleFinding::Kind, within a kind the largest newtons first
  analysis::Lint model;          ///< reachable range, bounds, completeness; its findings are among those above
  bool newtons_complete = true;  ///< false where a huge model used up the time for looking at forces
};

/// All findings about `model`, which must be valid, with `compiled` made from it. `origins`: one for each expert in the
/// model's order (BuiltModel::experts), or none where only the model is known; then no item is missing and rules are
/// named by their number. Experts are compared only where the force is in newtons. It ends soon after `stop` says so;
/// what it found until then is of no use.
RuleLint ruleLint(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                  std::span<const ExpertRules> origins = {}, const RuleLintSettings& settings = {},
                  const std::stop_token& stop = {});

}  // namespace tactus::elicitation
