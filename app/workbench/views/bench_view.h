// The screen of the research mode: the header of the model, and the panels of the present stage.
#pragma once

#include <QWidget>

#include "app/workbench/views/stage.h"
#include "core/base/error.h"

class QSettings;

namespace tactus::workbench {

class CurvesPanel;
class FeelController;
class MapPanel;
class PanelArea;
class SceneController;

class BenchView : public QWidget {
  Q_OBJECT

 public:
  BenchView(SceneController& scene, FeelController& feel, QSettings& settings, QWidget* parent = nullptr);

  PanelArea& panels() { return *panels_; }

  /// Writes the curves as a picture to `path` (PNG, SVG or PDF by its ending).
  base::Result<void> saveCurves(const QString& path);
  /// The same of the map.
  base::Result<void> saveMap(const QString& path);

 signals:
  void saveCurvesRequested();
  void saveMapRequested();

 private:
  void place();

  PanelArea* panels_;
  CurvesPanel* curves_;
  MapPanel* map_;
};

}  // namespace tactus::workbench
