// The curves as a table.
#pragma once

#include <vector>

#include "app/workbench/base/plot_table.h"

namespace tactus::workbench {

class SceneController;

/// Which lines are shown, and so stand in the table.
struct ShownCurves {
  bool mean = true;
  std::vector<bool> experts;  ///< one per expert
  std::vector<bool> family;   ///< one per value of the family, if there is one
  bool range = false;         ///< of the experts; two columns
  bool deviation = false;     ///< of the experts, one standard deviation
};

/// The x axis, then a column for each line that is shown; empty where no rule fires. `notes` go into the caption.
PlotTable curveTable(const SceneController& scene, const ShownCurves& shown, QStringList notes);

}  // namespace tactus::workbench
