// The color of a force for map, surface and their scales. It is the color ramp of the output's terms.
#pragma once

#include <QBrush>
#include <QColor>

namespace tactus::workbench {

/// Color of a force at `share` of the way from the lowest to the highest force of the universe. Values beyond the ends
/// get the color of the end.
QColor forceColor(double share);

/// The background where no rule fires: hatched, like the gaps of the curves.
QBrush silentGround();

}  // namespace tactus::workbench
