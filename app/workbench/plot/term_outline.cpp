#include "app/workbench/plot/term_outline.h"

#include <algorithm>

#include "app/workbench/plot/term_colors.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {
namespace {

void addPoint(TermOutline& outline, const fuzzy::MembershipFunction& function, double x) {
  outline.x << x;
  outline.membership << function(x);
}

}  // namespace

TermOutline outlineOf(const fuzzy::Term& term, double low, double high) {
  const fuzzy::MembershipFunction function = fuzzy::MembershipFunction::of(term);
  TermOutline outline;
  if (function.gaussian) {
    constexpr int kSteps = 96;
    for (int i = 0; i <= kSteps; ++i) addPoint(outline, function, low + (high - low) * i / kSteps);
    return outline;
  }
  const double first = std::max(low, function.a);
  const double last = std::min(high, function.d);
  if (first > last) return outline;
  if (function.a >= low) {
    outline.x << function.a;
    outline.membership << 0;
  }
  addPoint(outline, function, first);
  for (const double corner : {function.b, function.c}) {
    if (corner > first && corner < last) addPoint(outline, function, corner);
  }
  addPoint(outline, function, last);
  if (function.d <= high) {
    outline.x << function.d;
    outline.membership << 0;
  }
  return outline;
}

bool addGhosts(QCustomPlot& plot, const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& now,
               const std::vector<fuzzy::Term>& before, double low, double high, bool fast) {
  bool some = false;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const fuzzy::Term* const same = fuzzy::findTerm(now, before[i].id);
    if (same != nullptr && same->shape == before[i].shape && same->points == before[i].points) continue;
    const TermOutline outline = outlineOf(before[i], low, high);
    QCPGraph* const graph = plot.addGraph();
    graph->setAdaptiveSampling(false);
    graph->setPen(ghostPen(termLine(variable, before, i), fast));
    graph->setData(outline.x, outline.membership, true);
    some = true;
  }
  return some;
}

void fillTable(PlotTable& table, const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms) {
  table.columns = {"term", columnName(variable), "membership"};
  for (const fuzzy::Term& term : terms) {
    double low = variable.min;
    double high = variable.max;
    if (term.shape != fuzzy::Shape::kGaussian) {
      low = std::min(low, term.points.front());
      high = std::max(high, term.points.back());
    }
    const TermOutline outline = outlineOf(term, low, high);
    for (qsizetype i = 0; i < outline.x.size(); ++i) {
      table.rows.push_back({term.id, outline.x[i], outline.membership[i]});
    }
  }
}

}  // namespace tactus::workbench
