#include "app/workbench/model/shown_impact.h"

#include <algorithm>
#include <iterator>

#include "app/figures/force_curves.h"
#include "core/base/check.h"

namespace tactus::workbench {

editing::GhostCurve curveBetween(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
                                 const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after,
                                 const CurveSetting& setting) {
  // The largest difference of lines that bend at vertices lies at one of them, in most cases.
  const auto before_x = figures::samplePositions(before, setting.x_input);
  const auto after_x = figures::samplePositions(after, setting.x_input);
  std::vector<double> places;
  std::set_union(before_x.begin(), before_x.end(), after_x.begin(), after_x.end(), std::back_inserter(places));
  auto compared = editing::ghostCurve(compiled_before, compiled_after, setting.x_input, setting.values, places);
  TACTUS_CHECK(compared.has_value());
  return std::move(*compared);
}

editing::EditImpact shownImpact(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
                                const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after,
                                const CurveSetting& setting) {
  editing::EditImpact impact = editing::editImpact(before, compiled_before, after, compiled_after);
  if (setting.values.size() != before.inputs.size() || setting.values.size() != after.inputs.size()) return impact;
  const auto curve = curveBetween(before, compiled_before, after, compiled_after, setting);
  editing::include(impact, curve, setting.x_input, setting.values);
  return impact;
}

}  // namespace tactus::workbench
