// The limits above which a change of force counts as a step for a hand on a device.
#pragma once

#include "core/analysis/force_steps.h"
#include "core/fuzzy/force_model.h"

namespace tactus::elicitation {

/// More than one just-noticeable difference, or steeper than the spring of the renderer of `model` (default spring if
/// it has no renderer).
analysis::StepLimits forceStepLimits(const fuzzy::ForceModel& model);

}  // namespace tactus::elicitation
