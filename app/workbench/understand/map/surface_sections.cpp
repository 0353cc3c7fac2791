#include "app/workbench/understand/map/surface_sections.h"

#include <algorithm>
#include <cmath>

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

}  // namespace tactus::workbench
