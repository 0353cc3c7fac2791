// The entries of the legend above the curves.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/workbench/understand/curves/curve_legend.h"

namespace tactus::workbench {

class CurvePlot;
class ReadingModel;
class SceneController;

/// The mean first; then either the experts (one entry for all if there are many) and the parts of their spread, or the
/// lines of a family. Calls `spread_changed` after a part of the spread was shown or hidden. All arguments must outlive
/// the items.
std::vector<CurveLegend::Item> curveItems(const SceneController& scene, CurvePlot& plot, ReadingModel& readings,
                                          const std::function<void()>& spread_changed);

/// The index of the item that belongs to `row` of the readings; nothing if there is none.
std::optional<int> curveItemOf(const SceneController& scene, int row);

}  // namespace tactus::workbench
