// The reference evaluations stored in a model.
#pragma once

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::elicitation {

/// Replaces the checks of `model` by 36 points spread evenly over the universes of its inputs (Halton 1960), rounded to
/// three decimals, with their forces. Returns the error of `fuzzy::compile`.
base::Result<void> setChecks(fuzzy::ForceModel& model);

}  // namespace tactus::elicitation
