// In which direction an expert's rules move the force along one input.
#pragma once

#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

enum class Direction { kFalls = -1, kMixed = 0, kRises = 1 };

struct ExpertDirection {
  Direction prevailing = Direction::kMixed;  ///< of three quarters of the steps or more
  std::vector<std::string> steps_against;    ///< steps against it, as text
};

/// Direction of `expert` over `input`; see lint.h for what a step is. kMixed also where there is no step.
ExpertDirection direction(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Variable& input);

/// `depth is nasopharynx and speed is slow`, sorted by input.
std::string describe(std::vector<fuzzy::Condition> conditions);

}  // namespace tactus::analysis
