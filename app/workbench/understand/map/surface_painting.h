// Paints a mesh cell by cell from the far end to the near one, all at once or in slices.
#pragma once

#include <QPointF>
#include <QRgb>
#include <cstddef>
#include <memory>
#include <vector>

#include "app/workbench/understand/map/surface_mesh.h"
#include "app/workbench/understand/map/surface_projection.h"

class QPainter;

namespace tactus::workbench {

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

}  // namespace tactus::workbench
