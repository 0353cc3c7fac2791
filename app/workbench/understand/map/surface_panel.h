// Force over two inputs as a surface. The panel has the same choices of axes and expert as the map.
#pragma once

#include "app/workbench/understand/map/map_view_panel.h"

namespace tactus::workbench {

class SurfacePlot;

class SurfacePanel : public MapViewPanel {
  Q_OBJECT

 public:
  SurfacePanel(const SceneController& scene, ForceMapController& map, QWidget* parent = nullptr);

 private:
  SurfacePanel(const SceneController& scene, ForceMapController& map, SurfacePlot* plot, QWidget* parent);
};

}  // namespace tactus::workbench
