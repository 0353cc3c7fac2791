// In which direction an expert's rules move the force along one input.
#pragma once

#include <optional>
#include <vector>

#include "core/analysis/force_probe.h"
#include "core/analysis/rule_steps.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

enum class Direction { kFalls = -1, kMixed = 0, kRises = 1 };

struct ExpertDirection {
  Direction prevailing = Direction::kMixed;  ///< of three quarters of the steps or more
  std::vector<NeighbourStep> steps_with;     ///< steps that go this way; none where it is mixed
  std::vector<NeighbourStep> steps_against;  ///< steps that go the other way; none where it is mixed
};

/// Direction of `expert` over input number `input`: steps between neighbouring rules (neighbourSteps) whose consequent
/// changes its place go up or down. kMixed also where there is no such step. `model` must be valid.
ExpertDirection direction(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, std::size_t input);

/// A change of the force between two points.
struct ForceChange {
  double newtons = 0;
  std::vector<double> from;
  std::vector<double> to;
};

/// How far the force of `expert` alone moves in the direction in which `step` changes the consequent: from the middle
/// of the core of the first term to that of the second, the other conditions met in full; the largest over at most
/// `samples` settings of the inputs that the rules do not mention and as many beside the best of them, 0 where the
/// other rules outweigh the step everywhere. Nothing where the expert abstains at one of the ends.
std::optional<ForceChange> changeAlong(ForceProbe& probe, std::size_t expert, const NeighbourStep& step,
                                       std::size_t samples);

/// For each expert the largest difference in newtons between its change of force from the lower to the upper end of
/// `input` and that of the mean of the other experts of weight > 0, over at most `samples` settings of the other
/// inputs and as many beside the best of them. Nothing where it never fires at both ends together with another one.
std::vector<std::optional<ForceChange>> differencesAlong(ForceProbe& probe, std::size_t input, std::size_t samples);

}  // namespace tactus::analysis
