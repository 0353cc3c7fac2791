// The force over two inputs as a surface that is turned with mouse and keys. The operating point is a dot on it, with
// the lines of the surface through it.
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/workbench/understand/map/map_view.h"
#include "app/workbench/understand/map/surface_picture.h"

namespace tactus::workbench {

/// While the picture changes it is painted as fine as half a frame allows, and as fine as the map is once it rests.
class SurfacePlot : public QWidget, public MapView {
  Q_OBJECT

 public:
  static constexpr double kQuickMs = 5;  ///< for the mesh of a picture that moves; walls and texts come on top
  static constexpr int kSliceMs = 6;     ///< of a picture that rests, at a time
  static constexpr int kRestMs = 150;    ///< without a change, until a picture counts as resting

  explicit SurfacePlot(QWidget* parent = nullptr);

  void setAxes(const fuzzy::Variable& x, const fuzzy::Variable& y, const fuzzy::Variable& output) override;
  void setMap(const ForceMap* map) override;
  void setPoint(double x, double y, std::optional<double> force_n, const QString& tag) override;

  const SurfaceLook& look() const { return frame_.look; }
  void setLook(const SurfaceLook& look);
  /// Nothing is left to refine.
  bool isRested() const { return rested_; }
  /// Cells along each input of the picture that is on the screen.
  std::size_t cellsShown() const { return cells_shown_; }

  QSize sizeHint() const override { return {560, 380}; }

  /// The surface as it is turned now, the whole of it.
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
  bool stale_ = true;  ///< picture_ is not that of the frame and the map
  bool rested_ = false;
  std::size_t cells_shown_ = 0;
  double cell_ns_ = 700;  ///< measured, of a quick picture
  std::unique_ptr<SurfaceImage> finest_;
  QTimer rest_;
  QTimer slices_;
  std::optional<QPointF> grabbed_;

  struct Point {
    double x = 0;  ///< share of the universe
    double y = 0;
    std::optional<double> height;
    QString tag;
  };
  std::optional<Point> point_;
};

}  // namespace tactus::workbench
