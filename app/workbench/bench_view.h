// The screen of the research mode: the model header and the panels of the current stage.
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

  /// Starts feeling on the chosen device, or stops it.
  void toggleFeel();

  /// The menus that copy and save the curves and the map. They work while the panels are hidden, too.
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
