// Force over two inputs: the map with the choice of its axes and of whose force it shows.
#pragma once

#include "app/workbench/controllers/force_map.h"
#include "app/workbench/views/card.h"
#include "core/base/error.h"

class QComboBox;
class QLabel;

namespace tactus::workbench {

class ForceMapPlot;
class Refresh;
class SceneController;

class MapPanel : public Card {
  Q_OBJECT

 public:
  explicit MapPanel(SceneController& scene, QWidget* parent = nullptr);

  /// Writes the map as a picture to `path` (PNG, SVG or PDF by its ending).
  base::Result<void> savePicture(const QString& path);

 signals:
  void savePictureRequested();

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  void adoptModel();
  void showChoice();
  void showMap();
  void showPoint();
  void onValue(std::size_t input);
  void setPoint(double x, double y);
  QString settingText() const;

  SceneController& scene_;
  ForceMapController map_;
  QComboBox* who_;
  QComboBox* x_input_;
  QComboBox* y_input_;
  ForceMapPlot* plot_;
  QLabel* missing_;
  Refresh* compute_;
  Refresh* draw_point_;
};

}  // namespace tactus::workbench
