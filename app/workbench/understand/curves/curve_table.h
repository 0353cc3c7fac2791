// The curves as a table.
#pragma once

#include <vector>

#include "app/workbench/base/plot_table.h"

namespace tactus::workbench {

class SceneController;

/// The visible lines, which are the columns of the table.
struct ShownCurves {
  bool mean = true;
  std::vector<bool> experts;  ///< one per expert
  std::vector<bool> family;   ///< one per value of the family, if there is one
  bool range = false;         ///< range of the experts; two columns
  bool deviation = false;     ///< one standard deviation of the experts
};

/// The x axis, then one column for each visible line; a cell is empty if no rule fires. `notes` go into the caption.
PlotTable curveTable(const SceneController& scene, const ShownCurves& shown, QStringList notes);

}  // namespace tactus::workbench
