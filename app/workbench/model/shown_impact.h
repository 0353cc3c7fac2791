// The effect of an edit on the force, as all parts of the screen show it: never less than on the curve on the screen.
#pragma once

#include <cstddef>
#include <vector>

#include "app/editing/edit_impact.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// The curve on the screen: the input on its x axis and a value for each input.
struct CurveSetting {
  std::size_t x_input = 0;
  std::vector<double> values;
};

/// The forces of both models along that curve, at the sample positions of both models.
editing::GhostCurve curveBetween(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
                                 const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after,
                                 const CurveSetting& setting);

/// editing::editImpact, raised to what the curve shows. If `setting` has no values, or values for another number of
/// inputs, no curve is used. Thread: any.
editing::EditImpact shownImpact(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
                                const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after,
                                const CurveSetting& setting);

}  // namespace tactus::workbench
