#include "app/workbench/plot/chart.h"

#include <QSharedPointer>
#include <utility>
#include <variant>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/plot/plot_canvas.h"
#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {
namespace {

QCPScatterStyle styleOf(const ChartDots& dots) {
  using Shape = ChartDots::Shape;
  QCPScatterStyle style;
  switch (dots.shape) {
    case Shape::kNone: break;
    case Shape::kDisc: style.setShape(QCPScatterStyle::ssDisc); break;
    case Shape::kCircle: style.setShape(QCPScatterStyle::ssCircle); break;
    case Shape::kSquare: style.setShape(QCPScatterStyle::ssSquare); break;
  }
  style.setSize(dots.size_px);
  style.setBrush(dots.fill);
  if (dots.pen) style.setPen(*dots.pen);
  return style;
}

}  // namespace

void styleAxis(QCPAxis& axis, const ChartAxis& wanted) {
  styleAxis(axis, wanted.universe);
  if (wanted.range) axis.setRange(wanted.range->first, wanted.range->second);
  if (wanted.round_ticks) axis.setTicker(QSharedPointer<QCPAxisTicker>::create());
  if (wanted.step > 0) {
    auto steps = QSharedPointer<QCPAxisTickerFixed>::create();
    steps->setTickStep(wanted.step);
    axis.setTicker(steps);
  }
  axis.setLabel(wanted.label);
  axis.grid()->setVisible(wanted.grid);
}

ChartAxis membershipAxis(double top) {
  ChartAxis axis;
  axis.universe.max = 1;
  axis.range = {0, top};
  axis.step = 0.5;
  return axis;
}

ChartLine filledLine(const QVector<double>& x, const QVector<double>& y, const QColor& color, double width,
                     float fill_alpha) {
  QColor fill = color;
  fill.setAlphaF(fill_alpha);
  return {x, y, QPen(color, width), {}, fill_alpha > 0 ? QBrush(fill) : QBrush(Qt::NoBrush)};
}

ChartView::ChartView(QWidget* parent, QSize picture) : QWidget(parent), picture_(picture), plot_(makePlot(this)) {
  makeColumn(this, {plot_});
  plot_->axisRect()->setMinimumMargins(QMargins(0, theme::kGrid, 2 * theme::kGrid, 0));
  clear();
}

void ChartView::clear() {
  plot_->clearPlottables();
  plot_->clearItems();
  plot_->axisRect()->setVisible(false);
  chart_ = {};
  redraw(*plot_);
}

void ChartView::setChart(Chart chart) {
  clear();
  chart_ = std::move(chart);
  plot_->axisRect()->setVisible(true);
  styleAxis(*plot_->xAxis, chart_.x);
  styleAxis(*plot_->yAxis, chart_.y);
  for (const auto& part : chart_.parts) {
    std::visit([this](const auto& one) { add(one); }, part);
  }
}

void ChartView::add(const ChartLine& line) {
  if (!line.is_function_of_x) {
    auto* const curve = new QCPCurve(plot_->xAxis, plot_->yAxis);
    curve->setPen(line.pen);
    curve->setBrush(line.fill);
    curve->setScatterStyle(styleOf(line.dots));
    curve->setData(line.x, line.y);
    return;
  }
  QCPGraph& graph = addShape(*plot_, Qt::transparent, 0, 0);
  graph.setPen(line.pen);
  graph.setBrush(line.fill);
  graph.setScatterStyle(styleOf(line.dots));
  const bool dots_alone = line.pen.style() == Qt::NoPen && line.fill.style() == Qt::NoBrush;
  if (dots_alone) graph.setLineStyle(QCPGraph::lsNone);
  graph.setData(line.x, line.y, true);
}

void ChartView::add(const ChartBand& band) {
  QCPGraph* const low = plot_->addGraph();
  QCPGraph* const high = plot_->addGraph();
  for (QCPGraph* const edge : {low, high}) edge->setPen(Qt::NoPen);
  low->setData(band.x, band.low, true);
  high->setData(band.x, band.high, true);
  high->setBrush(band.fill);
  high->setChannelFillGraph(low);
}

void ChartView::add(const ChartBar& bar) {
  auto* const rect = new QCPItemRect(plot_);
  rect->topLeft->setCoords(bar.left, bar.top);
  rect->bottomRight->setCoords(bar.right, bar.bottom);
  rect->setPen(Qt::NoPen);
  rect->setBrush(bar.fill);
}

void ChartView::add(const ChartRule& rule) {
  const bool upright = rule.direction == Qt::Vertical;
  auto* const line = new QCPItemStraightLine(plot_);
  line->setPen(rule.pen);
  line->point1->setCoords(upright ? rule.at : 0, upright ? 0 : rule.at);
  line->point2->setCoords(upright ? rule.at : 1, upright ? 1 : rule.at);
}

void ChartView::add(const ChartText& text) {
  auto* const label = new QCPItemText(plot_);
  label->setText(text.words);
  label->setFont(theme::smallFont());
  label->setColor(text.ink);
  label->setPositionAlignment(text.side);
  label->setPadding(text.room);
  label->position->setCoords(text.at);
}

void ChartView::paintPicture(QCPPainter& painter, const QSize& size) { paintPlot(*plot_, painter, size, {}); }

}  // namespace tactus::workbench
