#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/feel/placement.h"
#include "app/workbench/kit/layout.h"
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
  makeColumn(this, {plot_});
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

namespace {

constexpr int kBarHeight = 14;  // px
constexpr int kLargeBarHeight = 30;
constexpr double kShownN = 0.0005;  // a thousandth of a newton is what the number shows

}  // namespace

ForceBar::ForceBar(QWidget* parent) : QWidget(parent), bar_height_(kBarHeight) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Force on the hand"));
}

void ForceBar::setForces(double force_n, double friction_n) {
  if (std::abs(force_n - force_n_) < kShownN && std::abs(friction_n - friction_n_) < kShownN) return;
  force_n_ = force_n;
  friction_n_ = friction_n;
  update();
}

void ForceBar::setScale(double full_n, double cap_n) {
  if (full_n == full_n_ && cap_n == cap_n_) return;
  full_n_ = full_n;
  cap_n_ = cap_n;
  update();
}

void ForceBar::setLarge(bool large) {
  bar_height_ = large ? kLargeBarHeight : kBarHeight;
  updateGeometry();
  update();
}

QSize ForceBar::sizeHint() const { return {240, bar_height_ + 4 + QFontMetrics(theme::smallFont()).height()}; }

void ForceBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF bar(0.5, 0.5, width() - 1, bar_height_ - 1);
  const auto xOf = [&](double newton) { return bar.left() + bar.width() * std::clamp(newton / full_n_, 0.0, 1.0); };
  QPainterPath frame;
  frame.addRoundedRect(bar, bar_height_ / 2.0, bar_height_ / 2.0);
  painter.fillPath(frame, theme::grid());
  painter.save();
  painter.setClipPath(frame);
  // A resistance against withdrawal fills the bar in another color.
  const double shown_n = std::abs(force_n_);
  painter.fillRect(QRectF(bar.topLeft(), QPointF(xOf(shown_n), bar.bottom())),
                   force_n_ >= 0 ? theme::accent() : theme::mutedInk());
  if (std::abs(friction_n_) > shown_n + kShownN)
    painter.fillRect(QRectF(QPointF(xOf(shown_n), bar.top()), QPointF(xOf(std::abs(friction_n_)), bar.bottom())),
                     QBrush(theme::warningInk(), Qt::BDiagPattern));
  painter.restore();
  painter.setPen(QPen(theme::border(), 1));
  painter.drawPath(frame);

  painter.setFont(theme::smallFont());
  painter.setPen(theme::mutedInk());
  if (cap_n_ <= full_n_) {
    painter.setPen(QPen(theme::errorInk(), 2));
    painter.drawLine(QPointF(xOf(cap_n_), 0), QPointF(xOf(cap_n_), bar.bottom() + 3));
    painter.setPen(theme::mutedInk());
  }
  paintScale(painter, QRectF(0, bar_height_ + 4, width(), height() - bar_height_ - 4), xOf);
}

// Numbers at each half newton, and the cap at the right end; a number that has no room beside it is left out.
void ForceBar::paintScale(QPainter& painter, const QRectF& scale, const std::function<double(double)>& x_of) const {
  const QString cap = tr("cap %1").arg(quantityText(cap_n_, "N"));
  const double cap_left = scale.right() - painter.fontMetrics().horizontalAdvance(cap);
  painter.drawText(scale, Qt::AlignRight | Qt::AlignVCenter, cap);
  for (double newton = 0; newton <= full_n_ + 1e-9; newton += 0.5) {
    const QString number = numberText(newton);
    const double half = painter.fontMetrics().horizontalAdvance(number) / 2.0 + 1;
    const double x = std::clamp(x_of(newton), half, scale.width() - half);
    if (x + half > cap_left - 6) break;
    painter.drawText(QRectF(x - half, scale.top(), 2 * half, scale.height()), Qt::AlignCenter | Qt::TextDontClip,
                     number);
  }
}

}  // namespace tactus::workbench
