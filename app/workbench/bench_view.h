// The screen of the research mode: the header of the model, and the panels of the present stage.
#pragma once

#include <QWidget>

#include "app/workbench/shell/stage.h"

class QSettings;

namespace tactus::workbench {

class CurvesPanel;
class FeelController;
class FeelPanel;
class MapPanel;
class ModelHeader;
class PanelArea;
class PlotMenu;
class SceneController;

class BenchView : public QWidget {
  Q_OBJECT

 public:
  BenchView(SceneController& scene, FeelController& feel, QSettings& settings, QWidget* parent = nullptr);

  PanelArea& panels() { return *panels_; }
  FeelPanel& feelPanel() { return *feel_panel_; }
  ModelHeader& header() { return *header_; }

  /// Starts feeling on the chosen device, or stops.
  void toggleFeel();

  /// What copies and saves the curves, and the map, whether they are shown or not.
  PlotMenu& curvesMenu();
  PlotMenu& mapMenu();

 private:
  void place();

  ModelHeader* header_ = nullptr;
  PanelArea* panels_;
  CurvesPanel* curves_;
  MapPanel* map_;
  FeelPanel* feel_panel_;
};

}  // namespace tactus::workbench
