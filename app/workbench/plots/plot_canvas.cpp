#include "app/workbench/plots/plot_canvas.h"

namespace tactus::workbench {

void PlotCanvas::paintEvent(QPaintEvent* event) {
  QCPPainter painter(this);
  if (!painter.isActive()) return;
  painter.fillRect(event->rect(), mBackgroundBrush);
  draw(&painter);
}

void PlotCanvas::resizeEvent(QResizeEvent* /*event*/) {
  setViewport(rect());
  updateLayout();
}

void FilledGraph::drawFill(QCPPainter* painter, QVector<QPointF>* lines) const {
  if (painter->brush().style() == Qt::NoBrush) return;
  drawInStrips(*painter, clipRect(), [&] { QCPGraph::drawFill(painter, lines); });
}

}  // namespace tactus::workbench
