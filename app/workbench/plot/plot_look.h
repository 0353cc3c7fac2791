// Keeps a plot in the current look: when the palette changes, its lines, axes and texts get the colors of the new look.
// Needs QCustomPlot: only plotting code includes this.
#pragma once

#include <qcustomplot.h>

namespace tactus::workbench {

/// Watches `plot`, which owns the watcher. Objects that paint with theme colors need nothing else. Colors from outside
/// the theme stay unchanged.
void followLook(QCustomPlot& plot);

}  // namespace tactus::workbench
