// The looks of all lines but those of the mean and the experts, in the plot of the curves and its legends.
#pragma once

#include "app/workbench/plot/plot_menu.h"

namespace tactus::workbench {

/// Line `index` of `count` of a family: gray, as it belongs to no expert and is no force; darker
/// and wider with the value, with dashes of its own.
QPen familyPen(std::size_t index, std::size_t count, bool fast = false);
/// The line of reference `index`. No expert and no mean has its color.
QPen referencePen(std::size_t index);

LegendEntry ghostLook(const QString& name);
LegendEntry rangeLook(const QString& name);
LegendEntry deviationLook(const QString& name);
/// A step of the force: a thick line in the error color.
LegendEntry stepLook(const QString& name);

/// The visible parts of a spread.
struct SpreadShown {
  bool range = true;
  bool deviation = false;
};

}  // namespace tactus::workbench
