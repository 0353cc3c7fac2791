// How lines other than those of the mean and the experts look, in the plot of the curves and in its legends.
#pragma once

#include "app/workbench/plot/plot_source.h"

namespace tactus::workbench {

/// Line `index` of `count` of a family: a ramp like that of terms, because the values have an order too.
QPen familyPen(std::size_t index, std::size_t count, bool fast = false);
/// The line of reference number `index`: colors that neither an expert nor the mean has.
QPen referencePen(std::size_t index);

LegendEntry ghostLook(const QString& name);
LegendEntry rangeLook(const QString& name);
LegendEntry deviationLook(const QString& name);
/// A step of the force: a thick piece in the color of errors.
LegendEntry stepLook(const QString& name);

/// Which parts of a spread are shown.
struct SpreadShown {
  bool range = true;
  bool deviation = false;
};

}  // namespace tactus::workbench
