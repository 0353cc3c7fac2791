// Force over two inputs as a surface, with the same choice of axes and of whose force it shows as the map.
#pragma once

#include "app/workbench/plot_table.h"
#include "app/workbench/views/card.h"

class QLabel;

namespace tactus::workbench {

class ElidedLabel;
class ForceMapController;
class MapChoice;
class PlotMenu;
class Refresh;
class SceneController;
class SurfacePlot;

class SurfacePanel : public Card {
  Q_OBJECT

 public:
  SurfacePanel(const SceneController& scene, ForceMapController& map, QWidget* parent = nullptr);

 private:
  void adoptModel();
  void showChoice();
  void showMap();
  void showPoint();
  void onMap();
  void onValue(std::size_t input);
  PlotTable table();

  const SceneController& scene_;
  ForceMapController& map_;
  MapChoice* choice_;
  SurfacePlot* plot_;
  PlotMenu* menu_;
  ElidedLabel* hint_;
  QLabel* missing_;
  Refresh* compute_;
  Refresh* draw_map_;
  Refresh* draw_point_;
};

}  // namespace tactus::workbench
