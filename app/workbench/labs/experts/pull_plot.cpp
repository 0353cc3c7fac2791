#include "app/workbench/labs/experts/pull_plot.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/labs/experts/experts_lab.h"
#include "app/workbench/plot/plot_style.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::workbench {
namespace {

constexpr double kMeanPx = 3.5;

QVector<double> forcesOf(const std::vector<fuzzy::Evaluation>& curve) {
  QVector<double> out;
  out.reserve(static_cast<qsizetype>(curve.size()));
  for (const fuzzy::Evaluation& one : curve) out << (one.fired ? one.force_n : qQNaN());
  return out;
}

}  // namespace

PullPlot::PullPlot(QWidget* parent) : QWidget(parent), plot_(makePlot(this)) {
  plot_->plotLayout()->clear();
  forces_ = new QCPAxisRect(plot_);
  pulls_ = new QCPAxisRect(plot_);
  plot_->plotLayout()->addElement(0, 0, forces_);
  plot_->plotLayout()->addElement(1, 0, pulls_);
  plot_->plotLayout()->setRowStretchFactor(0, 1.3);
  auto* margins = new QCPMarginGroup(plot_);
  for (QCPAxisRect* area : {forces_, pulls_}) {
    area->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    area->setMinimumMargins(QMargins(0, theme::kGrid, 2 * theme::kGrid, 0));
    for (QCPAxis* axis : area->axes()) axis->setLayer(QStringLiteral("axes"));
    for (QCPAxis* axis : area->axes()) axis->grid()->setLayer(QStringLiteral("grid"));
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid / 2, theme::kGrid / 2, theme::kGrid / 2, theme::kGrid / 2);
  layout->addWidget(plot_);
  setMinimumSize(320, 220);
  setAccessibleName(tr("Averaged force and the experts' distances from it"));
}

QCPGraph& PullPlot::addLine(QCPAxisRect& area, const QPen& pen) {
  QCPGraph* const graph = plot_->addGraph(area.axis(QCPAxis::atBottom), area.axis(QCPAxis::atLeft));
  graph->setPen(pen);
  graph->setAdaptiveSampling(false);
  return *graph;
}

void PullPlot::clear() {
  plot_->clearGraphs();
  legend_.clear();
  redraw(*plot_);
}

void PullPlot::setCurves(const fuzzy::ForceModel& model, std::size_t x_input, const figures::ForceCurves& curves) {
  plot_->clearGraphs();
  legend_.clear();
  if (curves.x.empty()) return redraw(*plot_);
  const fuzzy::Variable& depth = model.inputs[x_input];
  for (QCPAxisRect* area : {forces_, pulls_}) {
    styleAxis(*area->axis(QCPAxis::atBottom), depth);
    area->axis(QCPAxis::atBottom)->grid()->setVisible(false);
  }
  forces_->axis(QCPAxis::atBottom)->setTickLabels(false);
  pulls_->axis(QCPAxis::atBottom)->setLabel(axisText(depth));
  const auto numbers = figures::expertNumbers(model.experts);
  drawForces(model, curves, numbers);
  drawPulls(model, curves, numbers);
  redraw(*plot_);
}

void PullPlot::setBand(const ShownBand* band) { band_ = band == nullptr ? std::nullopt : std::optional(*band); }

void PullPlot::drawBand(const figures::ForceCurves& curves) {
  QVector<double> x(curves.x.begin(), curves.x.end());
  QVector<double> low;
  QVector<double> high;
  if (band_) {
    x = QVector<double>(band_->x.begin(), band_->x.end());
    for (const elicitation::BandPoint& point : band_->band.points) {
      low << (point.force_n ? point.low_n : qQNaN());
      high << (point.force_n ? point.high_n : qQNaN());
    }
  }
  for (qsizetype i = 0; !band_ && i < x.size(); ++i) {
    double least = qQNaN();
    double most = qQNaN();
    for (const auto& expert : curves.experts) {
      const fuzzy::Evaluation& one = expert[static_cast<std::size_t>(i)];
      if (!one.fired) continue;
      least = std::isnan(least) ? one.force_n : std::min(least, one.force_n);
      most = std::isnan(most) ? one.force_n : std::max(most, one.force_n);
    }
    low << least;
    high << most;
  }
  QColor fill = theme::mean();
  fill.setAlphaF(0.12F);
  QCPGraph& bottom = addLine(*forces_, Qt::NoPen);
  QCPGraph& top = addLine(*forces_, Qt::NoPen);
  bottom.setData(x, low, true);
  top.setData(x, high, true);
  top.setBrush(theme::onCard(fill));
  top.setChannelFillGraph(&bottom);
  const QString name = band_ ? bandMeaning(band_->kind) : tr("From the lowest to the highest expert");
  legend_.push_back({name, Qt::NoPen, theme::onCard(fill)});
}

void PullPlot::drawForces(const fuzzy::ForceModel& model, const figures::ForceCurves& curves,
                          const std::vector<std::size_t>& numbers) {
  const QVector<double> x(curves.x.begin(), curves.x.end());
  QCPAxis* const left = forces_->axis(QCPAxis::atLeft);
  styleAxis(*left, model.output);
  left->setLabel(axisText(model.output));
  drawBand(curves);
  for (std::size_t e = 0; e < curves.experts.size(); ++e) {
    const QPen pen = expertPen(numbers[e], numbers.size());
    addLine(*forces_, pen).setData(x, forcesOf(curves.experts[e]), true);
    legend_.push_back({harmless(labelOf(model.experts[e])), pen});
  }
  const QPen pen(theme::mean(), kMeanPx);
  addLine(*forces_, pen).setData(x, forcesOf(curves.mean), true);
  legend_.push_back({tr("Mean"), pen});
}

void PullPlot::drawPulls(const fuzzy::ForceModel& model, const figures::ForceCurves& curves,
                         const std::vector<std::size_t>& numbers) {
  const QVector<double> x(curves.x.begin(), curves.x.end());
  const auto pulls = pullsOf(curves);
  double widest = 0.1;  // N: small distances are not blown up
  for (const auto& pull : pulls) {
    for (const double one : pull) widest = std::isnan(one) ? widest : std::max(widest, std::abs(one));
  }
  fuzzy::Variable axis = model.output;
  axis.max = std::ceil(widest * 10) / 10;
  axis.min = -axis.max;
  QCPAxis* const left = pulls_->axis(QCPAxis::atLeft);
  styleAxis(*left, axis);
  left->setLabel(tr("From the mean (%1)").arg(text(model.output.unit)));
  // What a hand does not notice around the mean.
  QVector<double> below;
  QVector<double> above;
  for (const fuzzy::Evaluation& one : curves.mean) {
    const double jnd = one.fired ? elicitation::justNoticeableDifference(one.force_n) : qQNaN();
    below << -jnd;
    above << jnd;
  }
  QCPGraph& bottom = addLine(*pulls_, Qt::NoPen);
  QCPGraph& top = addLine(*pulls_, Qt::NoPen);
  bottom.setData(x, below, true);
  top.setData(x, above, true);
  top.setBrush(theme::grid());
  top.setChannelFillGraph(&bottom);
  legend_.push_back({tr("Not noticeable: within one just-noticeable difference"), Qt::NoPen, theme::grid()});
  addLine(*pulls_, QPen(theme::mean(), 1)).setData({curves.x.front(), curves.x.back()}, {0, 0}, true);
  for (std::size_t e = 0; e < pulls.size(); ++e) {
    addLine(*pulls_, expertPen(numbers[e], numbers.size()))
        .setData(x, QVector<double>(pulls[e].begin(), pulls[e].end()), true);
  }
}

void PullPlot::paintPicture(QCPPainter& painter, const QSize& size) { paintPlot(*plot_, painter, size, {}); }

}  // namespace tactus::workbench
