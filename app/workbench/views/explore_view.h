// The screen that explores a model: it only puts the panels in their places.
#pragma once

#include <QWidget>

#include "core/base/error.h"

namespace tactus::workbench {

class CurvesPanel;
class SceneController;

class ExploreView : public QWidget {
  Q_OBJECT

 public:
  explicit ExploreView(SceneController& scene, QWidget* parent = nullptr);

  /// Writes the curves as a picture to `path` (PNG, SVG or PDF by its ending).
  base::Result<void> savePicture(const QString& path);

 signals:
  void savePictureRequested();

 private:
  CurvesPanel* curves_;
};

}  // namespace tactus::workbench
