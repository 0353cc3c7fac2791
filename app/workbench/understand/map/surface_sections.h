// The operating point on a surface: where it stands, the lines of the surface through it, and which parts of them the
// surface itself hides. No widget, no painting.
#pragma once

#include <optional>
#include <vector>

#include "app/workbench/understand/map/surface_mesh.h"
#include "app/workbench/understand/map/surface_projection.h"

namespace tactus::workbench {

/// Height of the mesh above a place of the floor (shares of x and y), between the nodes bilinear; nothing over a hole
/// or beside the mesh.
std::optional<double> heightAt(const SurfaceMesh& mesh, double x, double y);

/// Whether the mesh stands between a place on it and the viewer.
bool isCovered(const SurfaceMesh& mesh, const BoxPoint& point, const BoxVector& to_viewer);

/// The lines of the surface through the place (x, y), along x and along y, as runs of points that the viewer sees.
std::vector<std::vector<BoxPoint>> visibleSections(const SurfaceMesh& mesh, double x, double y,
                                                   const BoxVector& to_viewer);

}  // namespace tactus::workbench
