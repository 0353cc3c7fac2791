// Force over two inputs as a color map. A click moves the operating point.
#pragma once

#include <QLineF>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/workbench/plot/plot_style.h"
#include "app/workbench/understand/map/map_view_panel.h"
#include "app/workbench/understand/map/surface_picture.h"

class QCPColorMap;
class QCPColorScale;
class QCustomPlot;
class QMouseEvent;

namespace tactus::workbench {

class AxisZoom;
class LandmarkMarks;
class ShownRanges;
class TermLabels;

// Force over two inputs as a surface. The panel has the same choices of axes and expert as the map.

// The force over two inputs as a surface that the user turns with mouse and keys. A dot marks the operating point, with
// the surface lines through it.

/// A moving picture is painted as fine as half a frame allows; at rest, as fine as the map.
class SurfacePlot : public QWidget, public MapView {
  Q_OBJECT

 public:
  static constexpr double kQuickMs = 5;  ///< for the mesh of a moving picture; walls and texts take extra time
  static constexpr int kSliceMs = 6;     ///< one painting slice of a resting picture
  static constexpr int kRestMs = 150;    ///< time without a change after which the picture is at rest

  explicit SurfacePlot(QWidget* parent = nullptr);

  void setAxes(const fuzzy::Variable& x, const fuzzy::Variable& y, const fuzzy::Variable& output) override;
  void setMap(const ForceMap* map) override;
  void setPoint(double x, double y, std::optional<double> force_n, const QString& tag) override;

  const SurfaceLook& look() const { return frame_.look; }
  void setLook(const SurfaceLook& look);
  /// Whether the picture is at rest and fully refined.
  bool isRested() const { return rested_; }
  /// The number of cells along each input in the visible picture.
  std::size_t cellsShown() const { return cells_shown_; }

  QSize sizeHint() const override { return {560, 380}; }

  /// The whole surface at its current angle.
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void changed();
  void paintQuick();
  void refine();
  void turn(double right_deg, double down_deg);
  void zoomBy(double factor, QPointF around);
  std::size_t quickStride() const;
  std::shared_ptr<const SurfaceMesh> mesh(std::size_t stride);
  void paintPoint(QPainter& painter);

  SurfaceFrame frame_;
  std::optional<ForceMap> map_;
  std::vector<std::pair<std::size_t, std::shared_ptr<const SurfaceMesh>>> meshes_;  ///< of the map, by stride
  QImage picture_;                                                                  ///< without the operating point
  bool stale_ = true;  ///< picture_ does not match the frame and the map
  bool rested_ = false;
  std::size_t cells_shown_ = 0;
  double cell_ns_ = 700;  ///< measured, of a quick picture
  std::unique_ptr<SurfaceImage> finest_;
  QTimer rest_{this};
  QTimer slices_{this};
  std::optional<QPointF> grabbed_;

  struct Point {
    double x = 0;  ///< in the units of the axes
    double y = 0;
    std::optional<double> height;
    QString tag;
  };
  std::optional<Point> point_;
};

class SurfacePlot;

class SurfacePanel : public MapViewPanel {
  Q_OBJECT

 public:
  SurfacePanel(const SceneController& scene, ForceMapController& map, QWidget* parent = nullptr);

 private:
  SurfacePanel(const SceneController& scene, ForceMapController& map, SurfacePlot* plot, QWidget* parent);
};

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
