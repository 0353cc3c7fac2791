// The operating point on a surface: its position, the surface lines through it, and the parts of them that the surface
// hides. No widget, no painting.
#pragma once

#include <optional>
#include <vector>

#include "app/workbench/understand/map/surface_mesh.h"
#include "app/workbench/understand/map/surface_projection.h"

namespace tactus::workbench {

/// Height of the mesh above a point of the floor (shares of x and y), bilinear between the nodes; nothing over a hole
/// or outside the mesh.
std::optional<double> heightAt(const SurfaceMesh& mesh, double x, double y);

/// Whether the mesh lies between a point on it and the viewer.
bool isCovered(const SurfaceMesh& mesh, const BoxPoint& point, const BoxVector& to_viewer);

/// The surface lines through (x, y), along x and along y, as runs of points that the viewer sees.
std::vector<std::vector<BoxPoint>> visibleSections(const SurfaceMesh& mesh, double x, double y,
                                                   const BoxVector& to_viewer);

}  // namespace tactus::workbench
