// A force map as a table, for every panel that shows it.
#pragma once

#include "app/workbench/base/plot_table.h"

namespace tactus::workbench {

class ForceMapController;
class SceneController;

/// The finest map of the current scene, computed now: one row for every point, x first; the force is empty if no rule
/// fires. The caption names the axes and the expert. A model with two inputs or more must be open.
PlotTable mapTable(const SceneController& scene, ForceMapController& map, const QString& suffix);

}  // namespace tactus::workbench
