// The direction in which an expert's rules move the force along one input.
#pragma once

#include <optional>
#include <vector>

#include "core/analysis/force_probe.h"
#include "core/analysis/rule_table.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

enum class Direction { kFalls = -1, kMixed = 0, kRises = 1 };

struct ExpertDirection {
  Direction prevailing = Direction::kMixed;  ///< direction of at least three quarters of the steps
  std::vector<NeighborStep> steps_with;      ///< steps in this direction; none if kMixed
  std::vector<NeighborStep> steps_against;   ///< steps in the other direction; none if kMixed
};

/// The direction of `expert` along input number `input`: it counts the steps between neighboring rules (neighborSteps)
/// that change the consequent, up or down. kMixed if there are none. `model` must be valid.
ExpertDirection direction(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, std::size_t input);

/// A change of the force between two points.
struct ForceChange {
  double newtons = 0;
  std::vector<double> from;
  std::vector<double> to;
};

/// The change of the force of `expert` alone along `step`, positive in the direction of the consequents. It goes from
/// the middle of the core of the first term to that of the second, with the other conditions fully met.
/// Returns the largest change over at most `samples` settings of the inputs that the rules do not mention, and as many
/// near the best of them. 0 if the other rules outweigh the step everywhere. Nothing if the expert abstains at one of
/// the ends.
std::optional<ForceChange> changeAlong(ForceProbe& probe, std::size_t expert, const NeighborStep& step,
                                       std::size_t samples);

/// For each expert: the largest difference in N between its own change of force from the lower to the upper end of
/// `input` and the change of the mean of the other experts of weight > 0. Tries at most `samples` settings of the other
/// inputs and as many near the best of them. Nothing if the expert never fires at both ends together with another one.
std::vector<std::optional<ForceChange>> differencesAlong(ForceProbe& probe, std::size_t input, std::size_t samples);

}  // namespace tactus::analysis
