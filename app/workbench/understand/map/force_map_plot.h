// The force over two inputs as a color map with contours. A cross marks the operating point; a click moves it.
#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/understand/map/map_view.h"

class QCPColorMap;
class QCPColorScale;
class QCustomPlot;
class QMouseEvent;

namespace tactus::workbench {

class AxisZoom;
class ContourMarks;
class LandmarkMarks;
class MapCross;
class ShownRanges;
class TermLabels;

class ForceMapPlot : public QWidget, public MapView {
  Q_OBJECT

 public:
  /// Shows the parts of the inputs in `ranges`, and changes them with the wheel and Shift-drag.
  explicit ForceMapPlot(ShownRanges& ranges, QWidget* parent = nullptr);

  void setAxes(const fuzzy::Variable& x, const fuzzy::Variable& y, const fuzzy::Variable& output) override;
  /// The terms along both axes, with their names.
  void setTerms(const std::vector<fuzzy::Term>& x, const std::vector<fuzzy::Term>& y);
  void setMap(const ForceMap* map) override;
  void setPoint(double x, double y, std::optional<double> force_n, const QString& tag) override;

  void paintPicture(QCPPainter& painter, const QSize& size) override;

 signals:
  /// The mouse was pressed or dragged at a point, in the units of the axes.
  void picked(double x, double y);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void onMouse(QMouseEvent* event);
  void makeRoom(int height);

  QCustomPlot* plot_;
  AxisZoom* zoom_;
  QCPColorMap* colors_ = nullptr;
  QCPColorScale* scale_ = nullptr;
  ContourMarks* contours_;
  TermLabels* x_terms_;
  TermLabels* y_terms_;
  LandmarkMarks* landmarks_;
  LandmarkMarks* y_landmarks_;
  MapCross* cross_;
  fuzzy::Variable x_;
  fuzzy::Variable y_;
  fuzzy::Variable output_;
};

}  // namespace tactus::workbench
