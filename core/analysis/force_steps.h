// Cliffs in the force: places where it changes so much within so little of an input that a hand feels a step.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/analysis/expert_spread.h"
#include "core/analysis/force_probe.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// How near two places of an input must be for a change of the force between them to be a step: 1 mm of an input in
/// mm, which a hand passes in some milliseconds; a 250th of the universe of any other input.
double stepWidth(const fuzzy::Variable& input);

/// What counts as a step between two places at most `stepWidth` apart.
struct StepLimits {
  /// More than this around the smaller of the two forces: the hand goes either way.
  NoticeableDifference noticeable;
  /// Or steeper than this, along inputs in mm: the spring of the renderer cannot follow. A change of less than
  /// `smallest_n` is never a step.
  double stiffness_n_mm = 0.25;
  double smallest_n = 0.001;  ///< the last digit of a force on the screen
};

/// A step of the averaged force or of one expert's.
struct ForceStep {
  std::optional<std::size_t> expert;  ///< index; nothing: the averaged force
  std::size_t input = 0;              ///< along which it goes
  std::vector<double> from;           ///< the place with the smaller value of `input`
  std::vector<double> to;             ///< the other one; the other inputs are the same
  double from_n = 0;                  ///< the forces there
  double to_n = 0;
  double noticeable = 0;  ///< noticeable differences between them
  bool steep = false;     ///< steeper than the limit
};

/// The steps along `input` with the other inputs as in `point`, of the mean first, ascending; of steps that overlap the
/// largest. Looks at both sides of every vertex of the terms and of every place where the strengths of rules cross,
/// within `stepWidth` of each, and at even places between, so a step is found however narrow it is. Where the experts
/// who fire change, nothing is compared across: that is a hole or an abstention. Some hundred to thousand forces.
std::vector<ForceStep> forceStepsAlong(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                       std::size_t input, std::span<const double> point, const StepLimits& limits);

/// The steps along all inputs, each at the setting of the other inputs where it is largest of those looked at: all
/// combinations of the vertices of their terms, then of the middles between them, as far as `evaluations` forces of all
/// experts go; two thirds of them along inputs in mm. With `only`: along that input alone. Steps of one who overlap are
/// one.
std::vector<ForceStep> forceSteps(ForceProbe& probe, const StepLimits& limits, std::size_t evaluations,
                                  std::optional<std::size_t> only = std::nullopt);

}  // namespace tactus::analysis
