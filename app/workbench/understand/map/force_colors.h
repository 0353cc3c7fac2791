// The color of a force: the ramp of the terms, so that what is amber as a term of the output is amber as a force. Map,
// surface and their scales take it from here.
#pragma once

#include <QBrush>
#include <QColor>

namespace tactus::workbench {

/// Color of the force that lies `share` of the way from the lowest to the highest force of the universe; beyond the
/// ends that of the end.
QColor forceColor(double share);

/// The ground where no rule fires: hatched, as the gaps of the curves.
QBrush silentGround();

}  // namespace tactus::workbench
