// Keeps a plot in the present look: its lines, axes and texts take the colors of a new look when the palette changes.
// Includes QCustomPlot, so only files of plots/ include it.
#pragma once

#include <qcustomplot.h>

namespace tactus::workbench {

/// Watches `plot`, which owns the watch. What draws itself with the colors of the theme needs nothing else; colors that
/// are not of the theme stay as they are.
void followLook(QCustomPlot& plot);

}  // namespace tactus::workbench
