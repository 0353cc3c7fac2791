// The forces of a map as a mesh of four-cornered cells in a box. Cells where no rule fires are holes.
#pragma once

#include <QPointF>
#include <QRectF>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/figures/surface_view.h"
#include "app/workbench/understand/map/force_map.h"

namespace tactus::workbench {

// The view of a surface's box on the screen.

using figures::BoxPoint;
using figures::BoxVector;
using figures::kBox;
using figures::SurfaceAngles;

class SurfaceProjection : public figures::SurfaceView {
 public:
  /// Fits the box into `area` (px) at every azimuth, then scales it by `zoom` and shifts it by `shift` px.
  SurfaceProjection(const SurfaceAngles& angles, const QRectF& area, double zoom = 1, QPointF shift = {});

  /// The position of a box point on the screen, px.
  QPointF operator()(const BoxPoint& point) const;

 private:
  QPointF middle_;
  double scale_ = 1;
};

/// A cell of the mesh: its corners are the nodes (x, y) to (x + 1, y + 1).
struct SurfaceCell {
  bool hole = true;   ///< no rule fires at a corner or between them; the other members then have no meaning
  double height = 0;  ///< mean of the corners, as a share of the force universe
  BoxVector normal;   ///< unit normal vector of the cell, upward
};

class SurfaceMesh {
 public:
  SurfaceMesh() = default;
  /// Takes every `stride`-th point of `map`, with forces as shares of [min_n, max_n]. `stride` must divide the map's
  /// side minus 1.
  SurfaceMesh(const ForceMap& map, double min_n, double max_n, std::size_t stride = 1);

  /// Cells along each input; 0 without a map.
  std::size_t cells() const { return cells_; }
  const SurfaceCell& cell(std::size_t x, std::size_t y) const { return cell_[y * cells_ + x]; }
  /// The node (x, y), both from 0 to cells(). Its height is 0 if no rule fires.
  BoxPoint node(std::size_t x, std::size_t y) const;

 private:
  std::size_t cells_ = 0;
  std::vector<double> height_;
  std::vector<SurfaceCell> cell_;
};

/// The painting order of the cells, so that nearer cells cover farther ones from every angle: rows and columns from the
/// far end to the near end. Reason: a ray to the viewer meets the cells above its path on the floor, and that path only
/// goes toward the near ends.
class PaintOrder {
 public:
  PaintOrder(std::size_t cells, const BoxVector& to_viewer)
      : cells_(cells), x_rises_(to_viewer.x >= 0), y_rises_(to_viewer.y >= 0) {}

  std::size_t count() const { return cells_ * cells_; }
  /// Column and row of the cell that is painted as number `index`.
  std::array<std::size_t, 2> at(std::size_t index) const {
    const std::size_t column = index % cells_;
    const std::size_t row = index / cells_;
    return {x_rises_ ? column : cells_ - 1 - column, y_rises_ ? row : cells_ - 1 - row};
  }
  bool xRises() const { return x_rises_; }
  bool yRises() const { return y_rises_; }

 private:
  std::size_t cells_;
  bool x_rises_;
  bool y_rises_;
};

// The operating point on a surface: its position, the surface lines through it, and the parts of them that the surface
// hides. No widget, no painting.

/// Height of the mesh above a point of the floor (shares of x and y), bilinear between the nodes; nothing over a hole
/// or outside the mesh.
std::optional<double> heightAt(const SurfaceMesh& mesh, double x, double y);

/// Whether the mesh lies between a point on it and the viewer.
bool isCovered(const SurfaceMesh& mesh, const BoxPoint& point, const BoxVector& to_viewer);

/// The surface lines through (x, y), along x and along y, as runs of points that the viewer sees.
std::vector<std::vector<BoxPoint>> visibleSections(const SurfaceMesh& mesh, double x, double y,
                                                   const BoxVector& to_viewer);

}  // namespace tactus::workbench
