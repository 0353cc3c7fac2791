// The line of a membership function over the universe of its variable, as plots draw it. Needs QCustomPlot: only
// plotting code includes this.
#pragma once

#include <vector>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {

struct TermOutline {
  QVector<double> x;
  QVector<double> membership;
};

/// The corners of the shape between `low` and `high`. A vertical edge has two points at one place.
TermOutline outlineOf(const fuzzy::Term& term, double low, double high);

/// Draws the terms of `before` that are others in `now`, dashed, in the colors of `variable`; between `low` and `high`.
/// `fast`: while something is dragged. Returns whether there were any.
bool addGhosts(QCustomPlot& plot, const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& now,
               const std::vector<fuzzy::Term>& before, double low, double high, bool fast = false);

/// Fills the columns `term`, the variable, and `membership`: a row for every corner of every term, also beyond the
/// universe. A Gaussian is sampled over the universe.
void fillTable(PlotTable& table, const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms);

}  // namespace tactus::workbench
