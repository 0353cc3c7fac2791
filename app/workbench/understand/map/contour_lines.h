// Lines of equal force through a map.
#pragma once

#include <QLineF>
#include <span>
#include <vector>

#include "app/workbench/understand/map/force_map.h"

namespace tactus::workbench {

/// The contour lines at the force `level_n`, as pieces in grid units: x and y from 0 to side - 1. Each piece is
/// straight within one cell. A cell with a corner where no rule fires has none. Method: marching squares (Lorensen and
/// Cline 1987, in two dimensions); a saddle is cut by the mean of its corners.
std::vector<QLineF> contourLines(const ForceMap& map, double level_n);
/// The same for several ascending levels in one pass over the map: a list of pieces for each level.
std::vector<std::vector<QLineF>> contourLines(const ForceMap& map, std::span<const double> levels_n);

/// The levels for a universe: about ten round numbers, without its ends.
std::vector<double> contourLevels(double min_n, double max_n);

}  // namespace tactus::workbench
