// What the legend above the curves lists.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/workbench/understand/curves/curve_legend.h"

namespace tactus::workbench {

class CurvePlot;
class ReadingModel;
class SceneController;

/// The mean first; then the experts, of many one item for all, and the parts of their spread; or the lines of a family.
/// `spread_changed` is called when a part of the spread was shown or hidden. All must live as long as the items.
std::vector<CurveLegend::Item> curveItems(const SceneController& scene, CurvePlot& plot, ReadingModel& readings,
                                          const std::function<void()>& spread_changed);

/// The item of `row` of the readings among them, or nothing.
std::optional<int> curveItemOf(const SceneController& scene, int row);

}  // namespace tactus::workbench
