#include "app/workbench/plot/plot_style.h"

#include <utility>
#include <vector>

#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/plot_canvas.h"
#include "app/workbench/plot/term_marks.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kTold = 24;  // six colors with four kinds of dashes
constexpr double kExpertPx = 1.6;
constexpr double kLeastContrast = 3;  // WCAG 2.1, 1.4.11

// The colors repeat after six experts; the dashes then tell them apart.
Qt::PenStyle dashesOf(std::size_t number) {
  constexpr Qt::PenStyle kStyles[] = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
  return kStyles[number / 6 % 4];
}

}  // namespace

QPen expertPen(std::size_t number, std::size_t count) {
  if (count <= kTold) return {theme::expert(number), kExpertPx, dashesOf(number)};
  // As pale as it can still be seen.
  double share = 0.5;
  QColor line = mixedColor(theme::card(), theme::expert(number), share);
  while (share < 1 && contrastOf(line, theme::card()) < kLeastContrast) {
    line = mixedColor(theme::card(), theme::expert(number), share += 0.05);
  }
  return {line, 1};
}

namespace {

Refresh* refreshOf(const QCustomPlot& plot) { return plot.findChild<Refresh*>(QString(), Qt::FindDirectChildrenOnly); }

constexpr double kGhostShare = 0.6;  // of a line's color; the rest is the ground

QPen inLook(QPen pen) {
  pen.setColor(theme::inLook(pen.color()));
  return pen;
}

QBrush inLook(QBrush brush) {
  if (brush.style() != Qt::NoBrush) brush.setColor(theme::inLook(brush.color()));
  return brush;
}

void take(QCPAxis& axis) {
  axis.setBasePen(inLook(axis.basePen()));
  axis.setTickPen(inLook(axis.tickPen()));
  axis.setSubTickPen(inLook(axis.subTickPen()));
  axis.setTickLabelColor(theme::inLook(axis.tickLabelColor()));
  axis.setLabelColor(theme::inLook(axis.labelColor()));
  axis.grid()->setPen(inLook(axis.grid()->pen()));
  axis.grid()->setZeroLinePen(inLook(axis.grid()->zeroLinePen()));
}

void takeLook(QCustomPlot& plot) {
  plot.setBackground(QBrush(theme::card()));
  for (QCPAxisRect* area : plot.axisRects()) area->setBackground(inLook(area->backgroundBrush()));
  for (QCPAxis* axis : plot.findChildren<QCPAxis*>()) take(*axis);
  for (int i = 0; i < plot.plottableCount(); ++i) {
    plot.plottable(i)->setPen(inLook(plot.plottable(i)->pen()));
    plot.plottable(i)->setBrush(inLook(plot.plottable(i)->brush()));
  }
  plot.replot(QCustomPlot::rpQueuedReplot);
}

void takeTextSize(QCustomPlot& plot, double factor) {
  const auto scaled = [factor](QFont font) {
    font.setPointSizeF(font.pointSizeF() * factor);
    return font;
  };
  for (QCPAxis* axis : plot.findChildren<QCPAxis*>()) {
    axis->setTickLabelFont(scaled(axis->tickLabelFont()));
    axis->setLabelFont(scaled(axis->labelFont()));
  }
  for (int i = 0; i < plot.itemCount(); ++i) {
    if (auto* item = qobject_cast<QCPItemText*>(plot.item(i))) item->setFont(scaled(item->font()));
  }
  plot.replot(QCustomPlot::rpQueuedReplot);
}

/// Gives lines, axes and texts the colors of the new look when the palette changes, and texts the new size. Colors from
/// outside the theme stay.
class LookWatch : public QObject {
 public:
  explicit LookWatch(QCustomPlot& plot) : QObject(&plot), plot_(plot) { plot_.installEventFilter(this); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::PaletteChange) takeLook(plot_);
    const double size = theme::smallFont().pointSizeF();
    if (event->type() == QEvent::FontChange && size != size_) takeTextSize(plot_, size / std::exchange(size_, size));
    return QObject::eventFilter(watched, event);
  }

 private:
  QCustomPlot& plot_;
  double size_ = theme::smallFont().pointSizeF();
};

}  // namespace

QCustomPlot* makePlot(QWidget* parent) {
  auto* plot = new PlotCanvas(parent);
  plot->setLocale(QLocale::c());
  plot->setBackground(QBrush(theme::card()));
  // Fills are not smoothed: the line around them covers their edge.
  plot->setAntialiasedElements(QCP::aeAll);
  plot->setNotAntialiasedElements(QCP::aeFills);
  plot->setNoAntialiasingOnDrag(false);
  // A smooth line drawn piece by piece takes a tenth of the time of one outline around all of it.
  plot->setPlottingHint(QCP::phFastPolylines);
  plot->legend->setVisible(false);
  // A hidden legend measures the names of hundreds of lines with every picture all the same.
  plot->setAutoAddPlottableToLegend(false);
  plot->setFocusPolicy(Qt::NoFocus);
  new Refresh(plot, [plot] { plot->update(); });
  new LookWatch(*plot);
  return plot;
}

void redraw(QCustomPlot& plot) { refreshOf(plot)->request(); }

QCPGraph& addShape(QCustomPlot& plot, const QColor& color, double width, float fill_alpha) {
  auto* graph = new FilledGraph(plot.xAxis, plot.yAxis);
  graph->setAdaptiveSampling(false);
  graph->setPen(QPen(color, width));
  QColor fill = color;
  fill.setAlphaF(fill_alpha);
  if (fill_alpha > 0) graph->setBrush(fill);
  return *graph;
}

void styleAxis(QCPAxis& axis, const fuzzy::Variable& variable) {
  axis.setRange(variable.min, variable.max);
  axis.setTicker(QSharedPointer<UniverseTicker>::create(variable.min, variable.max));
  axis.setNumberFormat(QStringLiteral("g"));
  axis.setNumberPrecision(5);
  axis.setSubTicks(false);
  axis.setBasePen(QPen(theme::border(), 1));
  axis.setTickPen(QPen(theme::border(), 1));
  axis.setTickLength(0, 4);
  axis.setTickLabelPadding(4);
  axis.setTickLabelColor(theme::mutedInk());
  axis.setLabelColor(theme::mutedInk());
  axis.setTickLabelFont(theme::smallFont());
  axis.setLabelFont(theme::smallFont());
  axis.grid()->setPen(QPen(theme::grid(), 1));
  axis.grid()->setZeroLinePen(QPen(theme::grid(), 1));
}

void paintPlot(QCustomPlot& plot, QCPPainter& painter, const QSize& size, std::initializer_list<QCPLayerable*> hidden) {
  std::vector<QCPLayerable*> shown;
  for (QCPLayerable* part : hidden) {
    if (!part->visible()) continue;
    shown.push_back(part);
    part->setVisible(false);
  }
  plot.toPainter(&painter, size.width(), size.height());
  for (QCPLayerable* part : shown) part->setVisible(true);
  // The picture has left its own layout behind.
  redraw(plot);
}

QVector<double> UniverseTicker::createTickVector(double step, const QCPRange& range) {
  QVector<double> ticks;
  // The end of a part of the universe is no number to remember.
  const bool low_end = range.lower <= min_;
  const bool high_end = range.upper >= max_;
  // A round number too near to an end would print over it.
  for (const double tick : QCPAxisTicker::createTickVector(step, range)) {
    if (tick < range.lower || tick > range.upper) continue;
    if ((!low_end || tick - range.lower > 0.6 * step) && (!high_end || range.upper - tick > 0.6 * step)) ticks << tick;
  }
  if (low_end) ticks.prepend(range.lower);
  if (high_end) ticks.append(range.upper);
  return ticks;
}

QColor fadedLine(const QColor& line) { return mixedColor(theme::card(), line, kGhostShare); }

QPen ghostPen(const QColor& line, bool fast) {
  QPen pen(fadedLine(line), fast ? 1 : 1.4, Qt::CustomDashLine);
  pen.setDashPattern({4, 3});
  return pen;
}

}  // namespace tactus::workbench
