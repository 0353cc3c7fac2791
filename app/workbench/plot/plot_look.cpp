#include "app/workbench/plot/plot_look.h"

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

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

class Watch : public QObject {
 public:
  explicit Watch(QCustomPlot& plot) : QObject(&plot), plot_(plot) { plot_.installEventFilter(this); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::PaletteChange) takeLook(plot_);
    return QObject::eventFilter(watched, event);
  }

 private:
  QCustomPlot& plot_;
};

}  // namespace

void followLook(QCustomPlot& plot) { new Watch(plot); }

}  // namespace tactus::workbench
