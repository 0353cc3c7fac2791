// The force over two inputs as a color map with contours. The operating point is a cross in it; a click sets it.
#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/controllers/force_map.h"
#include "app/workbench/plots/plot_source.h"
#include "core/fuzzy/force_model.h"

class QCPColorMap;
class QCPColorScale;
class QCustomPlot;
class QMouseEvent;

namespace tactus::workbench {

class ContourMarks;
class LandmarkMarks;
class MapCross;

class ForceMapPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit ForceMapPlot(QWidget* parent = nullptr);

  void setAxes(const fuzzy::Variable& x, const fuzzy::Variable& y, const fuzzy::Variable& output);
  /// The map for the axes that were set, or none.
  void setMap(const ForceMap* map);
  /// The operating point and what stands beside it.
  void setPoint(double x, double y, const QString& tag);

  void paintPicture(QCPPainter& painter, const QSize& size) override;

 signals:
  /// The mouse was pressed or dragged at a place, in the units of the axes.
  void picked(double x, double y);

 private:
  void onMouse(QMouseEvent* event);

  QCustomPlot* plot_;
  QCPColorMap* colors_ = nullptr;
  QCPColorScale* scale_ = nullptr;
  ContourMarks* contours_;
  LandmarkMarks* landmarks_;
  LandmarkMarks* y_landmarks_;
  MapCross* cross_;
  fuzzy::Variable x_;
  fuzzy::Variable y_;
};

}  // namespace tactus::workbench
