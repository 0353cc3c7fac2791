#include "app/workbench/understand/map/surface_mesh.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace tactus::workbench {
namespace {

constexpr int kPlaces = 150;      // of a section
constexpr double kStep = 0.008;   // of a ray to the viewer, in lengths of the box
constexpr double kClear = 0.004;  // share of the force by which the mesh stands in the way; less is the place itself

}  // namespace

std::optional<double> heightAt(const SurfaceMesh& mesh, double x, double y) {
  if (mesh.cells() == 0 || x < 0 || x > 1 || y < 0 || y > 1) return std::nullopt;
  const auto cells = static_cast<double>(mesh.cells());
  const std::size_t column = std::min(static_cast<std::size_t>(x * cells), mesh.cells() - 1);
  const std::size_t row = std::min(static_cast<std::size_t>(y * cells), mesh.cells() - 1);
  if (mesh.cell(column, row).hole) return std::nullopt;
  const double right = x * cells - static_cast<double>(column);
  const double up = y * cells - static_cast<double>(row);
  return std::lerp(std::lerp(mesh.node(column, row).z, mesh.node(column + 1, row).z, right),
                   std::lerp(mesh.node(column, row + 1).z, mesh.node(column + 1, row + 1).z, right), up);
}

bool isCovered(const SurfaceMesh& mesh, const BoxPoint& point, const BoxVector& to_viewer) {
  const double floor_way = std::hypot(to_viewer.x, to_viewer.y);
  if (floor_way < 1e-9) return false;
  const double step_x = to_viewer.x / floor_way * kStep / kBox.x;
  const double step_y = to_viewer.y / floor_way * kStep / kBox.y;
  const double step_z = to_viewer.z / floor_way * kStep / kBox.z;
  BoxPoint at = point;
  while (true) {
    at = {at.x + step_x, at.y + step_y, at.z + step_z};
    if (at.x < 0 || at.x > 1 || at.y < 0 || at.y > 1) return false;
    const std::optional<double> height = heightAt(mesh, at.x, at.y);
    if (!height) continue;
    // From above the mesh hides what is below it, from below what is above it.
    if (to_viewer.z >= 0 ? *height > at.z + kClear : *height < at.z - kClear) return true;
  }
}

std::vector<std::vector<BoxPoint>> visibleSections(const SurfaceMesh& mesh, double x, double y,
                                                   const BoxVector& to_viewer) {
  std::vector<std::vector<BoxPoint>> runs;
  for (const bool along_x : {true, false}) {
    runs.emplace_back();
    for (int i = 0; i <= kPlaces; ++i) {
      const double share = static_cast<double>(i) / kPlaces;
      BoxPoint point{along_x ? share : x, along_x ? y : share, 0};
      const std::optional<double> height = heightAt(mesh, point.x, point.y);
      if (height) point.z = *height;
      if (height && !isCovered(mesh, point, to_viewer)) {
        runs.back().push_back(point);
      } else if (!runs.back().empty()) {
        runs.emplace_back();
      }
    }
  }
  std::erase_if(runs, [](const auto& run) { return run.size() < 2; });
  return runs;
}

SurfaceProjection::SurfaceProjection(const SurfaceAngles& angles, const QRectF& area, double zoom, QPointF shift)
    : SurfaceView(angles), middle_(area.center() + shift) {
  // The floor's diagonal is its greatest extent at any azimuth, so turning does not change the size.
  const double diagonal = std::hypot(kBox.x, kBox.y);
  const double sin_e = toViewer().z;
  const double height = kBox.z * up().z + diagonal * std::abs(sin_e);
  scale_ = zoom * std::max(1.0, std::min(area.width() / diagonal, area.height() / height));
}

QPointF SurfaceProjection::operator()(const BoxPoint& point) const {
  const figures::SeenPoint at = SurfaceView::operator()(point);
  return {middle_.x() + scale_ * at.x, middle_.y() - scale_ * at.y};
}

namespace {

// Whether a rule fires at all places of the map in the square from `x`, `y`, `stride` wide.
bool allFired(const ForceMap& map, std::size_t x, std::size_t y, std::size_t stride) {
  for (std::size_t j = y; j <= y + stride; ++j) {
    for (std::size_t i = x; i <= x + stride; ++i) {
      if (!map.isFired(i, j)) return false;
    }
  }
  return true;
}

}  // namespace

SurfaceMesh::SurfaceMesh(const ForceMap& map, double min_n, double max_n, std::size_t stride)
    : cells_((map.side - 1) / stride) {
  TACTUS_CHECK(map.side > 1 && max_n > min_n && cells_ * stride == map.side - 1);
  const std::size_t side = cells_ + 1;
  height_.resize(side * side);
  for (std::size_t y = 0; y < side; ++y) {
    for (std::size_t x = 0; x < side; ++x) {
      if (!map.isFired(x * stride, y * stride)) continue;
      const double share = (map.force(x * stride, y * stride) - min_n) / (max_n - min_n);
      height_[y * side + x] = std::clamp(share, 0.0, 1.0);
    }
  }
  cell_.resize(cells_ * cells_);
  const double width_x = kBox.x / static_cast<double>(cells_);
  const double width_y = kBox.y / static_cast<double>(cells_);
  for (std::size_t y = 0; y < cells_; ++y) {
    for (std::size_t x = 0; x < cells_; ++x) {
      if (!allFired(map, x * stride, y * stride, stride)) continue;
      SurfaceCell& cell = cell_[y * cells_ + x];
      const double a = height_[y * side + x];
      const double b = height_[y * side + x + 1];
      const double c = height_[(y + 1) * side + x + 1];
      const double d = height_[(y + 1) * side + x];
      cell.hole = false;
      cell.height = (a + b + c + d) / 4;
      const double rise_x = (b + c - a - d) / 2 * kBox.z / width_x;
      const double rise_y = (c + d - a - b) / 2 * kBox.z / width_y;
      cell.normal = figures::normalOf(rise_x, rise_y);
    }
  }
}

BoxPoint SurfaceMesh::node(std::size_t x, std::size_t y) const {
  const auto cells = static_cast<double>(cells_);
  return {static_cast<double>(x) / cells, static_cast<double>(y) / cells, height_[y * (cells_ + 1) + x]};
}

}  // namespace tactus::workbench
