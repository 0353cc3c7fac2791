// The smallest difference of forces that a hand feels.
#pragma once

#include <cstddef>
#include <vector>

#include "core/analysis/force_steps.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::elicitation {

// The limits above which a change of force counts as a step for a hand on a device.

/// More than one just-noticeable difference, or steeper than the spring of the renderer of `model` (default spring if
/// it has no renderer).
analysis::StepLimits forceStepLimits(const fuzzy::ForceModel& model);

/// The just-noticeable difference around `force_n` >= 0: sqrt(0.04^2 + (0.12 F)^2) N. Absolute threshold and Weber
/// fraction: King 2010, Feyzabadi 2013.
double justNoticeableDifference(double force_n);

// How far two models differ for a hand that makes one stroke.

struct StrokeDifference {
  double rms_jnd = 0;  ///< root mean square along the stroke, in just-noticeable differences around the first force
  double largest_jnd = 0;
  double largest_n = 0;         ///< the difference there, second minus first
  double at_mm = 0;             ///< its depth
  double mean_n = 0;            ///< second minus first
  std::size_t places = 0;       ///< at which both have a force
  std::size_t without_one = 0;  ///< at which one of them, or both, have none; left out
};
/// From `from_mm` to `to_mm`, in steps of about 1 mm. `point`: one value for each input of the models, which are the
/// same; that of `depth_input` is moved.
StrokeDifference strokeDifference(const fuzzy::CompiledModel& first, const fuzzy::CompiledModel& second,
                                  std::vector<double> point, std::size_t depth_input, double from_mm, double to_mm);

}  // namespace tactus::elicitation
