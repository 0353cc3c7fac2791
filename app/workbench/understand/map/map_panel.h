// Force over two inputs as a color map. A click moves the operating point.
#pragma once

#include "app/workbench/understand/map/map_view_panel.h"

namespace tactus::workbench {

class ForceMapPlot;

class MapPanel : public MapViewPanel {
  Q_OBJECT

 public:
  MapPanel(SceneController& scene, ForceMapController& map, QWidget* parent = nullptr);

 private:
  MapPanel(SceneController& scene, ForceMapController& map, ForceMapPlot* plot, QWidget* parent);

  void catchUp() override;
  void showTerms();

  const SceneController& scene_;
  const ForceMapController& map_;
  ForceMapPlot* plot_;
};

}  // namespace tactus::workbench
