// The common interface of the color map and the surface for the panel around them.
#pragma once

#include <QString>
#include <optional>

#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/understand/map/force_map.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

class MapView : public PlotSource {
 public:
  /// The map says which parts of the universes it shows. The axes become the universes of `x`, `y` and of the force.
  /// This removes the map.
  virtual void setAxes(const fuzzy::Variable& x, const fuzzy::Variable& y, const fuzzy::Variable& output) = 0;
  /// The map for the current axes; null: none.
  virtual void setMap(const ForceMap* map) = 0;
  /// The operating point and its label. `force_n` is nothing if no rule fires.
  virtual void setPoint(double x, double y, std::optional<double> force_n, const QString& tag) = 0;
};

}  // namespace tactus::workbench
