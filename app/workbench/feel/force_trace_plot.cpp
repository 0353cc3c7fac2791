#include "app/workbench/feel/force_trace_plot.h"

#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/feel/feel_history.h"
#include "app/workbench/model/shown_ranges.h"
#include "app/workbench/plot/axis_zoom.h"
#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {
namespace {

using fuzzy::Variable;

constexpr double kHeadroom = 1.08;
constexpr int kLow = 130;  // px: below this height the lines need the room of the axes' names

QCPGraph* addLine(QCustomPlot& plot, const QPen& pen) {
  QCPGraph* graph = plot.addGraph();
  graph->setPen(pen);
  return graph;
}

Variable timeAxis() { return {"time", ForceTracePlot::tr("Time").toStdString(), "s", -FeelHistory::kTraceS, 0, {}}; }

}  // namespace

ForceTracePlot::ForceTracePlot(QWidget* parent)
    : QWidget(parent),
      plot_(makePlot(this)),
      ranges_(new ShownRanges(this)),
      zoom_(new AxisZoom(*plot_, *ranges_)),
      force_name_(tr("Force").toStdString()) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setMinimumWidth(200);
  setAccessibleName(tr("Force of the last ten seconds"));

  // The limits first, so that the lines stand above the fill.
  limits_ = addLine(*plot_, Qt::NoPen);
  model_ = addLine(*plot_, QPen(theme::mean(), 1.4));
  friction_ = addLine(*plot_, QPen(theme::friction(), 1.4));
  recorded_ = addLine(*plot_, QPen(theme::mutedInk(), 1.4, Qt::DashLine));
  force_ = addLine(*plot_, QPen(theme::accent(), 2));
  QColor taken = theme::errorInk();
  taken.setAlpha(60);
  limits_->setBrush(taken);
  limits_->setChannelFillGraph(force_);

  styleAxis(*plot_->xAxis, timeAxis());
  zoom_->setInputs(timeAxis());
  styleAxis(*plot_->yAxis, forceAxis());
  plot_->yAxis->setTicker(QSharedPointer<QCPAxisTicker>::create());
  plot_->axisRect()->setAutoMargins(QCP::msLeft | QCP::msBottom);
  plot_->axisRect()->setMargins(QMargins(0, theme::kGrid, 2 * theme::kGrid, 0));
  nameAxes(height() >= kLow);
  setSplit(false);
}

void ForceTracePlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  nameAxes(height() >= kLow);
}

void ForceTracePlot::nameAxes(bool roomy) {
  plot_->xAxis->setLabel(roomy ? axisText(timeAxis()) : QString());
  plot_->yAxis->setLabel(roomy ? axisText(forceAxis()) : QStringLiteral("N"));
  plot_->yAxis->ticker()->setTickCount(roomy ? 3 : 2);
}

double ForceTracePlot::topN() const { return plot_->yAxis->range().upper; }

fuzzy::Variable ForceTracePlot::forceAxis() const { return {"force", force_name_, "N", 0, full_n_, {}}; }

void ForceTracePlot::setOutput(const fuzzy::Variable& output) {
  force_name_ = labelOf(output).toStdString();
  full_n_ = output.max;
  plot_->yAxis->setRange(0, full_n_);
  nameAxes(height() >= kLow);
  redraw(*plot_);
}

void ForceTracePlot::setSplit(bool split) {
  split_ = split;
  for (QCPGraph* part : {limits_, model_, friction_}) part->setVisible(split);
  redraw(*plot_);
}

void ForceTracePlot::setHistory(const FeelHistory& history) {
  replays_ = history.hasRecorded();
  const auto& trace = history.trace();
  QVector<double> time, force, friction, model;
  for (QVector<double>* column : {&time, &force, &friction, &model})
    column->reserve(static_cast<qsizetype>(trace.size()));
  double lowest_n = 0;
  double highest_n = full_n_ / kHeadroom;
  for (const TracePoint& point : trace) {
    time << point.time_s - history.nowS();
    force << point.force_n;
    friction << point.friction_n;
    model << point.model_n;
    lowest_n = std::min({lowest_n, point.force_n, split_ ? point.friction_n : 0});
    highest_n = std::max({highest_n, point.force_n, split_ ? std::max(point.friction_n, point.model_n) : 0});
  }
  force_->setData(time, force, true);
  QVector<double> recorded_time, recorded;
  for (const TracePoint& point : trace) {
    if (!point.recorded_n) continue;
    recorded_time << point.time_s - history.nowS();
    recorded << *point.recorded_n;
    lowest_n = std::min(lowest_n, *point.recorded_n);
    highest_n = std::max(highest_n, *point.recorded_n);
  }
  recorded_->setData(recorded_time, recorded, true);
  if (split_) {
    friction_->setData(time, friction, true);
    limits_->setData(time, friction, true);
    model_->setData(time, model, true);
  }
  plot_->yAxis->setRange(lowest_n * kHeadroom, highest_n * kHeadroom);
  redraw(*plot_);
}

std::vector<LegendEntry> ForceTracePlot::legend() const {
  std::vector<LegendEntry> entries{{replays_ ? tr("present model, calculated") : tr("felt"), force_->pen()}};
  if (replays_) entries.push_back({tr("felt in the recording"), recorded_->pen()});
  if (split_) {
    entries.push_back({tr("fuzzy force"), model_->pen()});
    entries.push_back({tr("friction"), friction_->pen()});
    entries.push_back({tr("limits"), Qt::NoPen, limits_->brush()});
  }
  return entries.size() > 1 ? entries : std::vector<LegendEntry>();
}

void ForceTracePlot::paintPicture(QCPPainter& painter, const QSize& size) {
  nameAxes(true);
  paintPlot(*plot_, painter, size, {});
  nameAxes(height() >= kLow);
}

}  // namespace tactus::workbench
