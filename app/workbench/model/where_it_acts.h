// Where in the input space a rule or an edit acts, as a point to go to and in words.
#pragma once

#include <QString>
#include <span>
#include <vector>

#include "core/analysis/coverage.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// The point next to `from` at which all conditions of `rule` hold fully; an input that the rule does not name keeps
/// its value. `from` has one value per input. `rule` belongs to `expert`, and `expert` to the valid `model`.
std::vector<double> pointOfRule(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Rule& rule,
                                std::span<const double> from);

/// The inputs of `region` that keep the setting `values` outside of it: `lubrication 0.4 to 0.6, speed 30 to 60 mm/s`.
/// The input `but` does not count. Empty if the setting lies inside.
QString rangesOutside(const fuzzy::ForceModel& model, const std::vector<analysis::InputRange>& region,
                      std::span<const double> values, std::size_t but);

}  // namespace tactus::workbench
