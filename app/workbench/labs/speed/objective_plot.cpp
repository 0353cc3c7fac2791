#include "app/workbench/labs/speed/objective_plot.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/theme.h"
#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {

ObjectivePlot::ObjectivePlot(QWidget* parent) : QWidget(parent), plot_(makePlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setMinimumSize(220, 140);
  setAccessibleName(tr("Objective against iteration"));
  plot_->axisRect()->setMinimumMargins(QMargins(0, theme::kGrid, 2 * theme::kGrid, 0));
}

void ObjectivePlot::show(const SpeedResult& result, const std::vector<ObjectiveTrace>& traces, std::size_t first) {
  plot_->clearPlottables();
  const std::vector<std::size_t> numbers = subjectNumbers(result);
  fuzzy::Variable iterations;
  iterations.max = 1;
  double highest = 1;
  for (std::size_t i = 0; i < traces.size() && first + i < numbers.size(); ++i) {
    const std::vector<double>& objective = traces[i].objective;
    if (objective.empty() || !(objective.back() > 0)) continue;
    QVector<double> x;
    QVector<double> y;
    for (std::size_t k = 0; k < objective.size(); ++k) {
      x << static_cast<double>(k);
      y << objective[k] / objective.back();
    }
    iterations.max = std::max(iterations.max, x.back());
    highest = std::max(highest, y.front());
    QCPGraph& line = addShape(*plot_, theme::expert(numbers[first + i]), 1.8, 0);
    line.setData(x, y, true);
    line.setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 4));
  }
  styleAxis(*plot_->xAxis, iterations);
  styleAxis(*plot_->yAxis, iterations);
  plot_->xAxis->setLabel(tr("Iteration of the textbook"));
  plot_->yAxis->setLabel(tr("J / its minimum"));
  plot_->yAxis->setTicker(QSharedPointer<QCPAxisTicker>::create());
  plot_->yAxis->setRange(1 - 0.05 * (highest - 1 + 0.01), 1 + 1.08 * (highest - 1 + 0.01));
  redraw(*plot_);
}

}  // namespace tactus::workbench
