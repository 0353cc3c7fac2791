// A force model and its compiled form, which belong together. An edit makes them once; history, plots and servo share
// them.
#pragma once

#include <memory>

#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::editing {

struct ReadyModel {
  fuzzy::ForceModel model;        ///< valid
  fuzzy::CompiledModel compiled;  ///< of `model`
};

/// Immutable, so any thread may read it. Never null, except where a comment says so.
using SharedModel = std::shared_ptr<const ReadyModel>;

/// Compiles `model`. A model that does not make sense is refused with the error of `fuzzy::validate`.
base::Result<SharedModel> ready(fuzzy::ForceModel model);

/// `model` with checks that are evaluated anew (refreshChecks); the same one if it has none.
SharedModel withFreshChecks(SharedModel model);

}  // namespace tactus::editing
