// A drawing of a force map: what the color map and the surface have in common for the panel around them.
#pragma once

#include <QString>
#include <optional>

#include "app/workbench/plot/plot_source.h"
#include "app/workbench/understand/map/force_map.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

class MapView : public PlotSource {
 public:
  /// The universes of `x`, `y` and of the force become the axes; the map is then that of others and goes.
  virtual void setAxes(const fuzzy::Variable& x, const fuzzy::Variable& y, const fuzzy::Variable& output) = 0;
  /// The map for the axes that were set, or none.
  virtual void setMap(const ForceMap* map) = 0;
  /// The operating point and what stands beside it. `force_n` is not set where no rule fires.
  virtual void setPoint(double x, double y, std::optional<double> force_n, const QString& tag) = 0;
};

}  // namespace tactus::workbench
