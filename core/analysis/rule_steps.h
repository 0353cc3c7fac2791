// Steps from one rule of an expert to the next along an input, and how many levels of the force each takes.
#pragma once

#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// Two rules of one expert with the same conditions but for the term of one input, and no rule for a term between them.
struct NeighbourStep {
  std::size_t input = 0;   ///< index of the input along which the step goes
  std::size_t before = 0;  ///< index in Expert::rules, the rule of the lower term
  std::size_t after = 0;
  int levels = 0;  ///< places from the first consequent to the second in the order of the output terms; may be < 0
  bool adjacent = false;  ///< no term of the expert lies between; otherwise the rule of one is missing

  bool operator==(const NeighbourStep&) const = default;
};

/// All steps of `expert` along input number `input`. Terms, of the input and of the output, are taken in the order of
/// their centres; terms with the same centre share a place, so between two of them there is no step and no level. Of a
/// rule that is given twice with different consequents, each makes its steps. Disabled rules and rules of weight 0 do
/// not count. `model` must be valid.
std::vector<NeighbourStep> neighbourSteps(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                                          std::size_t input);

/// `speed from slow to fast where depth is stomach, force from small to large`
std::string describe(const NeighbourStep& step, const fuzzy::ForceModel& model, const fuzzy::Expert& expert);

/// `depth is nasopharynx and speed is slow`, sorted by input.
std::string describe(std::vector<fuzzy::Condition> conditions);

}  // namespace tactus::analysis
