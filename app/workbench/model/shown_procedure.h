// The procedure that the model on the screen is about.
#pragma once

#include <QString>
#include <cstddef>
#include <memory>
#include <optional>

#include "core/fuzzy/force_model.h"
#include "core/procedure/procedure.h"

namespace tactus::workbench {

using ProcedurePtr = std::shared_ptr<const procedure::Procedure>;

/// The procedure of `model`: `of_study`, that of the open study, if the model names it; else the one that the program
/// carries by that name; the default one for a model that names none and has only inputs of it. Null: not known.
ProcedurePtr procedureFor(const fuzzy::ForceModel& model, const ProcedurePtr& of_study);

/// Procedure::device_scale; 1 where it is not known.
inline double deviceScaleOf(const ProcedurePtr& procedure) {
  return procedure != nullptr ? procedure->device_scale : 1;
}

/// A text of a pack in the language of the program.
QString inProgramLanguage(const procedure::Texts& texts);

/// What stands beside an axis of the way is of this procedure, in every plot: the default one at first. Null: nothing.
void showProcedure(ProcedurePtr procedure);
const ProcedurePtr& shownProcedure();

/// The input of `model` of which a nurse changes the pose with one gesture: the pack draws its levels as poses and
/// gives words for the gesture (`pose.INPUT.on`, `pose.INPUT.off`). Nothing without one, or with fewer than two terms.
std::optional<std::size_t> posedInput(const procedure::Procedure* procedure, const fuzzy::ForceModel& model);

}  // namespace tactus::workbench
