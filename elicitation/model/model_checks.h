// The reference evaluations stored in a model.
#pragma once

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::elicitation {

/// Replaces the checks of `model` by at most 120 points with their forces, chosen so that the ordinary mistakes of a
/// program that reads the file show (core/analysis/check_points.h). Returns the error of `fuzzy::validate`.
base::Result<void> setChecks(fuzzy::ForceModel& model);

}  // namespace tactus::elicitation
