// A smooth line through points (Catmull and Rom): each piece is a cubic whose control points lie at a sixth of the
// chord between the neighbors.
#pragma once

#include <QPointF>
#include <cstddef>
#include <vector>

namespace tactus::workbench::anatomy {

/// `steps` points for each piece of the line through `through` (two points or more), and its last point.
std::vector<QPointF> smoothLine(const std::vector<QPointF>& through, std::size_t steps);

}  // namespace tactus::workbench::anatomy
