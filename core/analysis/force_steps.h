// Cliffs of the force: it changes so much within a short range of an input that the hand feels a step.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/analysis/expert_spread.h"
#include "core/analysis/force_probe.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// The largest distance of two positions of an input between which a change of the force counts as a step. For an input
/// in mm: 1 mm, which a hand passes in some milliseconds. For any other input: 1/250 of its universe.
double stepWidth(const fuzzy::Variable& input);

/// The criteria for a step between two positions at most `stepWidth` apart.
struct StepLimits {
  /// A step changes by more than this around the smaller of the two forces, because the hand moves in both directions.
  NoticeableDifference noticeable;
  /// Along an input in mm, a steeper change is also a step, because the spring of the renderer cannot follow it. A
  /// change below `smallest_n` is never a step.
  double stiffness_n_mm = 0.25;
  double smallest_n = 0.001;  ///< the last digit of a force on the screen
};

/// A step of the averaged force or of one expert's force.
struct ForceStep {
  std::optional<std::size_t> expert;  ///< index; empty: the averaged force
  std::size_t input = 0;              ///< the input that changes
  std::vector<double> from;           ///< the point with the smaller value of `input`
  std::vector<double> to;             ///< the point with the larger value; all other inputs are equal
  double from_n = 0;                  ///< force at `from`, then at `to`
  double to_n = 0;
  double noticeable = 0;  ///< number of noticeable differences between them
  bool steep = false;     ///< steeper than the limit
};

/// The steps along `input`, with the other inputs as in `point`: first those of the mean, in ascending order. Of
/// overlapping steps it returns the largest.
/// It tries both sides of every vertex and of every crossing of rule strengths, points within `stepWidth` of them, and
/// evenly spaced points between. So it finds a step however narrow it is. It does not compare across a change of the
/// firing experts: that is a hole or an abstention. Costs some hundred to a thousand forces.
std::vector<ForceStep> forceStepsAlong(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                       std::size_t input, std::span<const double> point, const StepLimits& limits);

/// The steps along all inputs, each at the setting of the other inputs with the largest step found. Tries all
/// combinations of the vertices of the other inputs, then of the midpoints, up to `evaluations` forces of all experts;
/// two thirds of them along inputs in mm. `only`: the only input to search. Overlapping steps of one expert are joined.
std::vector<ForceStep> forceSteps(ForceProbe& probe, const StepLimits& limits, std::size_t evaluations,
                                  std::optional<std::size_t> only = std::nullopt);

}  // namespace tactus::analysis
