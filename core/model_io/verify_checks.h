// Repeats the reference evaluations stored in a model.
#pragma once

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::model_io {

/// Evaluates each of `model.checks`. Returns an error of kind kMismatch at `/checks/N` if a force differs by more than
/// 1e-12 of the output range, or `fired` differs. Returns the error of `fuzzy::validate` if the model is invalid.
base::Result<void> verifyChecks(const fuzzy::ForceModel& model);

}  // namespace tactus::model_io
