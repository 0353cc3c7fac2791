// What every edit of a force model gives: the model after it, compiled, and what changed in words.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::editing {

/// A finished edit. Edits are pure functions of the model before: during a drag each one starts from the model at the
/// beginning of the gesture (EditHistory::base), so that a drag that runs into a neighbour and back leaves nothing
/// behind.
struct Edit {
  fuzzy::ForceModel model;        ///< valid
  fuzzy::CompiledModel compiled;  ///< of `model`: to be felt and plotted without compiling again
  std::string label;              ///< `Insertion depth / Nasopharynx: right foot 125 to 132 mm`
  std::string stopped;            ///< why it went less far than asked; empty where it did not stop
};

/// Compiles `model`. A model that does not make sense is refused with the error of `fuzzy::validate`.
base::Result<Edit> finished(fuzzy::ForceModel model, std::string label, std::string stopped = {});

/// Evaluates the checks of `model` anew, at the points that it has; `compiled` is made from it. An edit makes them
/// wrong, and a model file with wrong checks is refused. EditHistory does this once for each gesture.
void refreshChecks(fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled);

}  // namespace tactus::editing
