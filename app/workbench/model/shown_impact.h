// How much an edit changes the force, as every part of the screen says it: with the curve that is on the screen.
#pragma once

#include <cstddef>
#include <vector>

#include "app/editing/edit_impact.h"
#include "app/editing/model_ghost.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// The curve on the screen: the input on its x axis and a value for each input.
struct CurveSetting {
  std::size_t x_input = 0;
  std::vector<double> values;
};

/// The forces of both models along that curve, at the places where the screen draws either.
editing::GhostCurve curveBetween(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
                                 const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after,
                                 const CurveSetting& setting);

/// editing::editImpact, and what the curve shows beyond it. `setting` without values, or of another number of inputs:
/// no curve. Thread: any.
editing::EditImpact shownImpact(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
                                const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after,
                                const CurveSetting& setting);

}  // namespace tactus::workbench
