// In which direction an expert's rules move the force along one input.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/analysis/force_probe.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

enum class Direction { kFalls = -1, kMixed = 0, kRises = 1 };

/// From one rule to the next along an input.
struct RuleStep {
  std::string text;
  std::vector<fuzzy::Condition> before;  ///< conditions of the rule the step starts from
  std::vector<fuzzy::Condition> after;
  bool rises = false;  ///< the consequent rises
};

struct ExpertDirection {
  Direction prevailing = Direction::kMixed;  ///< of three quarters of the steps or more
  std::vector<RuleStep> steps_against;       ///< steps against it
};

/// Direction of `expert` over `input`; see lint.h for what a step is. kMixed also where there is no step.
ExpertDirection direction(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Variable& input);

/// A change of the force between two points.
struct ForceChange {
  double newtons = 0;
  std::vector<double> from;
  std::vector<double> to;
};

/// How far the force of `expert` alone moves in the direction of `step`: from the middle of the core of the first term
/// to that of the second, the other conditions met in full; the largest over at most `samples` settings of the inputs
/// that the rules do not mention and as many beside the best of them, 0 where the other rules outweigh the step
/// everywhere. Nothing where the expert abstains at one of the ends.
std::optional<ForceChange> changeAlong(ForceProbe& probe, std::size_t expert, const RuleStep& step,
                                       std::size_t samples);

/// For each expert the largest difference in newtons between its change of force from the lower to the upper end of
/// `input` and that of the mean of the other experts of weight > 0, over at most `samples` settings of the other
/// inputs and as many beside the best of them. Nothing where it never fires at both ends together with another one.
std::vector<std::optional<ForceChange>> differencesAlong(ForceProbe& probe, std::size_t input, std::size_t samples);

/// `depth is nasopharynx and speed is slow`, sorted by input.
std::string describe(std::vector<fuzzy::Condition> conditions);

}  // namespace tactus::analysis
