// Force over two inputs as a color map, with the choice of its axes and of whose force it shows.
#pragma once

#include "app/workbench/plot_table.h"
#include "app/workbench/views/card.h"

class QLabel;

namespace tactus::workbench {

class ForceMapController;
class ForceMapPlot;
class MapChoice;
class PlotMenu;
class Refresh;
class SceneController;

class MapPanel : public Card {
  Q_OBJECT

 public:
  MapPanel(SceneController& scene, ForceMapController& map, QWidget* parent = nullptr);

  PlotMenu& plotMenu() { return *menu_; }

 private:
  void adoptModel();
  void showChoice();
  void showMap();
  void showPoint();
  void onMap();
  void onValue(std::size_t input);
  void setPoint(double x, double y);
  PlotTable table();

  SceneController& scene_;
  ForceMapController& map_;
  MapChoice* choice_;
  ForceMapPlot* plot_;
  PlotMenu* menu_;
  QLabel* missing_;
  Refresh* compute_;
  Refresh* draw_map_;
  Refresh* draw_point_;
};

}  // namespace tactus::workbench
