#include "app/workbench/understand/map/surface_mesh.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace tactus::workbench {
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
