// A force map as a table, for every panel that shows it.
#pragma once

#include "app/workbench/base/plot_table.h"

namespace tactus::workbench {

class ForceMapController;
class SceneController;

/// The finest map of the scene as it is now, which is computed at once: a row for every place, x first, the force empty
/// where no rule fires. The caption names the axes and whose force it is. A model with two inputs or more must be open.
PlotTable mapTable(const SceneController& scene, ForceMapController& map, const QString& suffix);

}  // namespace tactus::workbench
