// The numbers of the pull plot: the averaged force and everybody's distance from it.
#pragma once

#include "app/workbench/base/plot_table.h"

namespace tactus::workbench {

class ExpertsLab;

/// A model must be built.
PlotTable pullTable(const ExpertsLab& lab);

}  // namespace tactus::workbench
