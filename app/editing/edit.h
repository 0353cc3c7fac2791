// The result of an edit of a force model: the new model, compiled, and the change in words.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::editing {

/// A finished edit. Edits are pure functions of the model before. During a drag each edit starts from the model at the
/// beginning of the gesture (EditHistory::base). So a drag into a neighbor and back leaves no trace.
struct Edit {
  fuzzy::ForceModel model;        ///< valid
  fuzzy::CompiledModel compiled;  ///< from `model`: to feel and plot it without compiling again
  std::string label;              ///< `Insertion depth / Nasopharynx: right foot 125 to 132 mm`
  std::string stopped;            ///< why the edit stopped short of the request; empty if it did not
};

/// Compiles `model`. An invalid model is refused with the error of `fuzzy::validate`.
base::Result<Edit> finished(fuzzy::ForceModel model, std::string label, std::string stopped = {});

/// Computes the expected forces of the checks in `model` again, at the same points; `compiled` is made from it. An edit
/// makes them wrong, and the reader refuses a model file with wrong checks. EditHistory does this once for each
/// gesture.
void refreshChecks(fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled);

}  // namespace tactus::editing
