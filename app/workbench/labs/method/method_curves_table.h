// The two curves of the method study as numbers, for files and the clipboard.
#pragma once

#include "app/workbench/base/plot_table.h"

namespace tactus::workbench {

class MethodLab;

/// Needs the curves of the chosen variant.
PlotTable methodCurvesTable(const MethodLab& lab);

}  // namespace tactus::workbench
