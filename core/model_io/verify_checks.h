// The reference evaluations that travel with a model, done again.
#pragma once

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::model_io {

/// Evaluates each of `model.checks`. A force off by more than 1e-12 of the output's range, or another `fired`, is an
/// error of kind kMismatch at `/checks/N`. A model that does not validate gives the error of `fuzzy::validate`.
base::Result<void> verifyChecks(const fuzzy::ForceModel& model);

}  // namespace tactus::model_io
