// Steps between neighboring rules of an expert along an input, and the change of the force level of each.
#pragma once

#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// Two rules of one expert with the same conditions except for the term of one input, and no rule for a term between.
struct NeighborStep {
  std::size_t input = 0;   ///< index of the input along which the step goes
  std::size_t before = 0;  ///< index in Expert::rules of the rule with the lower term
  std::size_t after = 0;
  int levels = 0;  ///< places from the first to the second consequent in the order of the output terms; may be < 0
  bool adjacent = false;  ///< no term of the expert lies between; false: the rule for a term between is missing

  bool operator==(const NeighborStep&) const = default;
};

/// All steps of `expert` along input number `input`. Input and output terms are ordered by their centers. Terms with
/// the same center share a place, so there is no step or level between them. If a rule occurs twice with different
/// consequents, each makes its own steps. Disabled rules and rules of weight 0 do not count. `model` must be valid.
std::vector<NeighborStep> neighborSteps(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, std::size_t input);

/// `speed from slow to fast where depth is stomach, force from small to large`
std::string describe(const NeighborStep& step, const fuzzy::ForceModel& model, const fuzzy::Expert& expert);

/// `depth is nasopharynx and speed is slow`, sorted by input.
std::string describe(std::vector<fuzzy::Condition> conditions);

}  // namespace tactus::analysis
