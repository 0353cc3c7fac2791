// Force over two inputs as a color map. A click moves the operating point.
#pragma once

#include <QLineF>
#include <QWidget>
#include <vector>

#include "app/workbench/plot/plot_style.h"
#include "app/workbench/understand/map/map_view_panel.h"

class QCPColorMap;
class QCPColorScale;
class QCustomPlot;
class QMouseEvent;

namespace tactus::workbench {

class AxisZoom;
class LandmarkMarks;
class ShownRanges;
class TermLabels;

// The force over two inputs as a color map with contours. A cross marks the operating point; a click moves it.

/// The marks over a color map: contour lines, and the cross at the operating point. Needs QCustomPlot: only plotting
/// code includes this.
class ContourMarks : public QCPLayerable {
  Q_OBJECT

 public:
  struct Line {
    QString text;                ///< the level, as written on the line
    QColor ground;               ///< the color of the level, behind the text
    std::vector<QLineF> pieces;  ///< in the units of the axes
  };

  explicit ContourMarks(QCustomPlot& plot);

  /// `labelled`: each line shows its level at a place where no other line crosses the number.
  void set(std::vector<Line> lines, bool labelled = false) {
    lines_ = std::move(lines);
    labelled_ = labelled;
  }

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  void drawLabels(QCPPainter& painter, const std::vector<QVector<QLineF>>& pieces) const;

  std::vector<Line> lines_;
  bool labelled_ = false;
};

class MapCross : public QCPLayerable {
  Q_OBJECT

 public:
  explicit MapCross(QCustomPlot& plot);

  void set(double x, double y, QString tag);

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  double x_ = 0;
  double y_ = 0;
  QString tag_;
  QFont font_;
};

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
