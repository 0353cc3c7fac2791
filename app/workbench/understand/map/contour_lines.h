// Lines of equal force through a map.
#pragma once

#include <QLineF>
#include <span>
#include <vector>

#include "app/workbench/understand/map/force_map.h"

namespace tactus::workbench {

/// Pieces of the lines on which the force is `level_n`, in units of the grid: x and y from 0 to side - 1. Straight
/// within each cell of the grid; none in a cell with a corner where no rule fires (marching squares, Lorensen and Cline
/// 1987 in two dimensions; a saddle is cut by the mean of its corners).
std::vector<QLineF> contourLines(const ForceMap& map, double level_n);
/// The same for several levels, ascending, in one pass over the map: a list of pieces for each.
std::vector<std::vector<QLineF>> contourLines(const ForceMap& map, std::span<const double> levels_n);

/// The levels for a universe: round numbers, about ten, without its ends.
std::vector<double> contourLevels(double min_n, double max_n);

}  // namespace tactus::workbench
