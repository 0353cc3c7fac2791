#include "app/workbench/understand/here/output_sets_plot.h"

#include <QVBoxLayout>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/plot_marks.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kMostFills = 12;

}  // namespace

OutputSetsPlot::OutputSetsPlot(QWidget* parent) : QWidget(parent), plot_(makePlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setMinimumSize(200, 120);
  setAccessibleName(tr("Clipped sets of the output and their centroid"));
  cursor_ = new ReadingCursor(*plot_);
  plot_->axisRect()->setMinimumMargins(QMargins(0, theme::kGrid / 2, 2 * theme::kGrid, 0));
}

void OutputSetsPlot::showExpert(const fuzzy::ForceModel& model, const analysis::Explanation& explanation,
                                std::size_t expert) {
  begin(model.output);
  const analysis::ExplainedExpert& explained = explanation.experts[expert];
  const std::vector<fuzzy::Term>& terms = fuzzy::termsFor(model.experts[expert], model.output);
  for (std::size_t i = 0; i < explained.output_terms.size(); ++i) {
    addSet(labelOf(terms[i]), explained.output_terms[i].set, theme::force(i, explained.output_terms.size()), 0.45F, 1);
  }
  addSet(tr("together"), explained.aggregated, theme::ink(), 0, 1.6);
  finish(!explained.abstains, explained.force_n,
         tr("centroid %1").arg(forceText(explained.force_n, model.output.unit)));
}

void OutputSetsPlot::showExperts(const fuzzy::ForceModel& model, const analysis::Explanation& explanation) {
  begin(model.output);
  // Many fills over each other say nothing any more, and outlines are enough.
  const bool many = explanation.experts.size() > kMostFills;
  const std::vector<std::size_t> numbers = figures::expertNumbers(model.experts);
  for (std::size_t i = 0; i < explanation.experts.size(); ++i) {
    addSet(labelOf(model.experts[i]), explanation.experts[i].aggregated, theme::expert(numbers[i]), many ? 0 : 0.1F,
           many ? 1 : 1.6);
  }
  finish(explanation.fired, explanation.force_n, tr("mean %1").arg(forceText(explanation.force_n, model.output.unit)));
}

void OutputSetsPlot::begin(const fuzzy::Variable& output) {
  output_ = output;
  styleAxis(*plot_->xAxis, output);
  styleAxis(*plot_->yAxis, output);
  plot_->xAxis->setLabel(axisText(output));
  plot_->xAxis->grid()->setVisible(false);
  plot_->yAxis->setRange(0, 1.06);
  auto ticker = QSharedPointer<QCPAxisTickerFixed>::create();
  ticker->setTickStep(0.5);
  plot_->yAxis->setTicker(ticker);
  plot_->clearGraphs();
}

void OutputSetsPlot::addSet(const QString& name, const analysis::Polyline& set, const QColor& color, float fill_alpha,
                            double width) {
  if (set.empty()) return;
  QVector<double> x{set.front().x};
  QVector<double> height{0};
  for (const analysis::Vertex& vertex : set) {
    x << vertex.x;
    height << vertex.height;
  }
  x << set.back().x;
  height << 0;
  QCPGraph& graph = addShape(*plot_, color, width, fill_alpha);
  graph.setName(name);
  graph.setData(x, height, true);
}

void OutputSetsPlot::finish(bool fired, double force_n, const QString& tag) {
  cursor_->setVisible(fired);
  cursor_->set(force_n, tag, {});
  redraw(*plot_);
}

std::vector<LegendEntry> OutputSetsPlot::legend() const {
  std::vector<LegendEntry> entries;
  for (int i = 0; i < plot_->graphCount(); ++i) {
    const QCPGraph& set = *plot_->graph(i);
    entries.push_back({set.name(), set.pen(), set.brush()});
  }
  return entries;
}

void OutputSetsPlot::fillTable(PlotTable& table) const {
  table.columns = {"set", columnName(output_), "height"};
  for (int i = 0; i < plot_->graphCount(); ++i) {
    const std::string name = plot_->graph(i)->name().toStdString();
    for (const QCPGraphData& corner : *plot_->graph(i)->data()) table.rows.push_back({name, corner.key, corner.value});
  }
}

// The force at the centroid is what the plot is about, so its mark stays.
void OutputSetsPlot::paintPicture(QCPPainter& painter, const QSize& size) { paintPlot(*plot_, painter, size, {}); }

}  // namespace tactus::workbench
