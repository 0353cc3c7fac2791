#include "app/workbench/labs/method/method_plot.h"

#include <QVBoxLayout>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/plot_style.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::workbench {
namespace {

constexpr double kNowPx = 3;
constexpr double kOtherPx = 2.2;

}  // namespace

MethodPlot::MethodPlot(QWidget* parent) : QWidget(parent), plot_(makePlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid / 2, theme::kGrid / 2, theme::kGrid / 2, theme::kGrid / 2);
  layout->addWidget(plot_);
  plot_->axisRect()->setMinimumMargins(QMargins(0, theme::kGrid, 2 * theme::kGrid, 0));
  setMinimumSize(320, 220);
  setAccessibleName(tr("Averaged force as it is and with another choice"));
  showAxes(false);
}

void MethodPlot::clear() {
  plot_->clearGraphs();
  plot_->clearItems();
  legend_.clear();
  showAxes(false);
  redraw(*plot_);
}

void MethodPlot::showAxes(bool shown) {
  for (QCPAxis* const axis : {plot_->xAxis, plot_->yAxis}) {
    axis->setVisible(shown);
    axis->grid()->setVisible(shown && axis == plot_->yAxis);
  }
}

void MethodPlot::addLine(const std::vector<double>& x, const std::vector<fuzzy::Evaluation>& forces,
                         const QString& name, const QPen& pen) {
  QVector<double> y;
  for (const fuzzy::Evaluation& one : forces) y << (one.fired ? one.force_n : qQNaN());
  QCPGraph* const graph = plot_->addGraph();
  graph->setPen(pen);
  graph->setAdaptiveSampling(false);
  graph->setData(QVector<double>(x.begin(), x.end()), y, true);
  legend_.push_back({name, pen});
}

void MethodPlot::setCurves(const fuzzy::ForceModel& model, const MethodCurves& curves, const QString& other,
                           bool marked) {
  plot_->clearGraphs();
  plot_->clearItems();
  legend_.clear();
  const fuzzy::Variable& depth = model.inputs[curves.x_input];
  styleAxis(*plot_->xAxis, depth);
  plot_->xAxis->setLabel(axisText(depth));
  styleAxis(*plot_->yAxis, model.output);
  plot_->yAxis->setLabel(axisText(model.output));
  showAxes(true);
  QVector<double> below;
  QVector<double> above;
  for (const fuzzy::Evaluation& one : curves.now.mean) {
    const double jnd = one.fired ? elicitation::justNoticeableDifference(one.force_n) : qQNaN();
    below << one.force_n - jnd;
    above << one.force_n + jnd;
  }
  const QVector<double> x(curves.now.x.begin(), curves.now.x.end());
  QCPGraph* const bottom = plot_->addGraph();
  QCPGraph* const top = plot_->addGraph();
  for (QCPGraph* const edge : {bottom, top}) edge->setPen(Qt::NoPen);
  bottom->setData(x, below, true);
  top->setData(x, above, true);
  top->setBrush(theme::grid());
  top->setChannelFillGraph(bottom);
  if (marked) {
    auto* const line = new QCPItemStraightLine(plot_);
    line->setPen(QPen(theme::accent(), 1, Qt::DashLine));
    line->point1->setCoords(curves.at[curves.x_input], 0);
    line->point2->setCoords(curves.at[curves.x_input], 1);
    legend_.push_back({tr("Where they differ most"), line->pen()});
  }
  addLine(curves.now.x, curves.now.mean, tr("As it is"), QPen(theme::mean(), kNowPx));
  addLine(curves.other.x, curves.other.mean, other, QPen(theme::warningInk(), kOtherPx));
  legend_.push_back({tr("Not noticeable: within one just-noticeable difference"), Qt::NoPen, theme::grid()});
  redraw(*plot_);
}

void MethodPlot::paintPicture(QCPPainter& painter, const QSize& size) { paintPlot(*plot_, painter, size, {}); }

}  // namespace tactus::workbench
