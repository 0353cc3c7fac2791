// The smallest difference of forces that a hand feels.
#pragma once

#include "core/analysis/force_steps.h"
#include "core/fuzzy/force_model.h"

namespace tactus::elicitation {

// The limits above which a change of force counts as a step for a hand on a device.

/// More than one just-noticeable difference, or steeper than the spring of the renderer of `model` (default spring if
/// it has no renderer).
analysis::StepLimits forceStepLimits(const fuzzy::ForceModel& model);

/// The just-noticeable difference around `force_n` >= 0: sqrt(0.04^2 + (0.12 F)^2) N. Absolute threshold and Weber
/// fraction: King 2010, Feyzabadi 2013.
double justNoticeableDifference(double force_n);

}  // namespace tactus::elicitation
