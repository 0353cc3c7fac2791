// The line of a membership function over the universe of its variable, as a plot draws it. Only files of plots/ include
// this.
#pragma once

#include "app/workbench/plots/plot_style.h"

namespace tactus::workbench {

struct TermOutline {
  QVector<double> x;
  QVector<double> membership;
};

/// The corners of the shape between `low` and `high`; a vertical edge has two points at one place.
TermOutline outlineOf(const fuzzy::Term& term, double low, double high);

}  // namespace tactus::workbench
