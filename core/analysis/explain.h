// All steps from the inputs to the force at one point, for the editor and its users.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/polyline.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

struct ExplainedInput {
  std::string id;
  double given = 0;
  double value = 0;  ///< clamped to the universe
};

struct TermMembership {
  std::string term;
  double membership = 0;
};

/// One rule at the point. `rule` is its index in Expert::rules.
struct ExplainedRule {
  std::size_t rule = 0;
  std::vector<double> memberships;     ///< one per condition, in the rule's order
  std::size_t smallest_condition = 0;  ///< index of the condition with the smallest membership; the first of equals
  double strength = 0;                 ///< weight times that membership; 0 for a disabled rule
  bool wins = false;                   ///< sets the strength of its output term: the first of the strongest rules
};

struct ExplainedOutputTerm {
  std::string term;
  double strength = 0;
  std::optional<std::size_t> winning_rule;  ///< index in Expert::rules; nothing if no rule fires for the term
  Polyline set;                             ///< clipped or scaled, within the universe; empty if the strength is 0
};

struct ExplainedExpert {
  std::string id;
  bool abstains = true;
  std::vector<std::vector<TermMembership>> memberships;  ///< per input, for the expert's own terms
  std::vector<ExplainedRule> rules;                      ///< all rules, in the order of the expert
  std::vector<ExplainedOutputTerm> output_terms;         ///< in the expert's order
  Polyline aggregated;                                   ///< maximum of the sets; empty if the expert abstains
  bool sampled = false;       ///< a set is Gaussian: the polylines are sampled finely, the force is exact
  double force_n = 0;         ///< exact centroid; the default force if the expert abstains
  double weight_share = 0;    ///< w / sum of w over the experts that do not abstain; 0 if this one abstains
  double contribution_n = 0;  ///< weight_share times force_n
};

struct Explanation {
  std::vector<ExplainedInput> inputs;
  std::vector<ExplainedExpert> experts;
  double force_n = 0;  ///< as in CompiledModel::evaluate; the sum of the contributions
  bool fired = false;
  bool is_default = true;  ///< every expert abstains, and the force is default_force_n of the model
};

/// Explains the force at one point. `compiled`: made from `model`. `inputs`: one value per input, in the model's order
/// and units. Returns an error for another number of values, or a value that is not finite.
base::Result<Explanation> explain(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                  std::span<const double> inputs);

}  // namespace tactus::analysis
