// The picture of a surface: its contents, its angle, and its painting, at once or in slices. No widget.
#pragma once

#include <QFont>
#include <QImage>
#include <QLineF>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QRgb>
#include <QString>
#include <QVector>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "app/workbench/plot/label_board.h"
#include "app/workbench/understand/map/surface_mesh.h"
#include "core/fuzzy/force_model.h"

class QPainter;

namespace tactus::workbench {

// The surroundings of a surface: walls with a grid, axes with numbers and names at the edges where they are readable,
// and the landmarks of a depth axis at the upper edge. They turn with the surface. No widget, no painting.

/// Where `value` lies in the universe: 0 at its beginning, 1 at its end.
double shareOf(const fuzzy::Variable& variable, double value);

struct SurfaceText {
  QString text;
  TurnedBox box;
};

struct SurfaceAxes {
  std::array<QPolygonF, 3> walls;    ///< behind the surface: across x, across y, and the floor or ceiling
  QVector<QLineF> grid;              ///< on the walls
  QVector<QLineF> edges;             ///< of the walls
  QVector<QLineF> axis_lines;        ///< axes and their ticks
  std::vector<SurfaceText> numbers;  ///< numbers at the ticks
  std::vector<SurfaceText> names;    ///< names of the axes, with their units
  QVector<QPolygonF> landmark_bars;  ///< extents of the landmarks
  QVector<QLineF> landmark_leads;    ///< from a bar to its name
  std::vector<SurfaceText> landmarks;
};

/// The axes of a box seen through `seen`, over the universes of `x`, `y` and of the force `z`. Texts are in `font`
/// (landmarks in italics) and inside `bounds`, px; none overlaps another. A text that does not fit is left out. An axis
/// that points at the viewer has no texts.
SurfaceAxes surfaceAxes(const SurfaceProjection& seen, const fuzzy::Variable& x, const fuzzy::Variable& y,
                        const fuzzy::Variable& z, const QFont& font, const QRectF& bounds);

/// The corner of the box away from the viewer: 0 or 1 along x, y and z.
BoxPoint farCorner(const SurfaceProjection& seen);

/// Paints a mesh cell by cell from the far end to the near one, all at once or in slices.
class SurfacePainting {
 public:
  enum class Quality {
    kQuick,   ///< hard edges, for a moving picture
    kSmooth,  ///< smooth edges, about five times slower
  };
  static constexpr std::size_t kMeshLines = 25;  ///< along each input, without the borders

  /// `mesh` must have at least one cell.
  SurfacePainting(std::shared_ptr<const SurfaceMesh> mesh, const SurfaceProjection& seen, Quality quality);

  /// Continues to paint until all is done or `budget_ms` have passed.
  void paint(QPainter& painter, double budget_ms);
  void paint(QPainter& painter);
  bool isDone() const { return next_ == order_.count(); }

 private:
  void paintCell(QPainter& painter, std::size_t x, std::size_t y) const;
  void paintEdges(QPainter& painter, std::size_t x, std::size_t y) const;
  bool isHole(std::size_t x, std::size_t y) const;
  const QPointF& node(std::size_t x, std::size_t y) const { return nodes_[y * (mesh_->cells() + 1) + x]; }

  std::shared_ptr<const SurfaceMesh> mesh_;
  SurfaceProjection seen_;
  Quality quality_;
  PaintOrder order_;
  std::size_t line_every_;      ///< cells between two mesh lines
  std::vector<QPointF> nodes_;  ///< on the screen
  std::size_t next_ = 0;
};

/// Color of a force at `share` of its universe, lit with `brightness`.
QRgb litColor(double share, double brightness);

struct SurfaceLook {
  SurfaceAngles angles;
  double zoom = 1;
  QPointF shift;  ///< px

  friend bool operator==(const SurfaceLook&, const SurfaceLook&) = default;
};

struct SurfaceFrame {
  fuzzy::Variable x;
  fuzzy::Variable y;
  fuzzy::Variable output;
  SurfaceLook look;
  QSizeF size;  ///< px of the whole drawing

  /// The areas of the box, the color scale beside it, and the texts.
  QRectF boxArea() const;
  QRectF scaleArea() const;
  QRectF textArea() const;
  SurfaceProjection projection() const;
  SurfaceAxes axes() const;
};

/// Paints the whole picture. `mesh` may be null if nothing is computed yet. Returns the painting time of the mesh, ns.
double paintSurface(QPainter& painter, const SurfaceFrame& frame, std::shared_ptr<const SurfaceMesh> mesh,
                    SurfacePainting::Quality quality);

/// A picture that is painted in slices into its own image.
class SurfaceImage {
 public:
  SurfaceImage(const SurfaceFrame& frame, std::shared_ptr<const SurfaceMesh> mesh, double device_pixel_ratio);

  /// Continues to paint for about `budget_ms`.
  void work(double budget_ms);
  bool isDone() const { return done_; }
  const QImage& image() const { return image_; }

 private:
  SurfaceFrame frame_;
  SurfaceAxes axes_;
  QImage image_;
  SurfacePainting painting_;
  bool done_ = false;
};

}  // namespace tactus::workbench
