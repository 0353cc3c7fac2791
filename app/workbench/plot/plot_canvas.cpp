#include "app/workbench/plot/plot_canvas.h"

#include <algorithm>
#include <cmath>

namespace tactus::workbench {
namespace {

// Of the device. Qt uses threads from 96 pieces of rows on; a set may have three pieces in a row.
constexpr double kRows = 30;

bool isVector(const QCPPainter& painter) { return painter.modes().testFlag(QCPPainter::pmVectorized); }

double stripHeight(const QCPPainter& painter) { return kRows / painter.device()->devicePixelRatioF(); }

// The part of `shape` on one side of a horizontal line (Sutherland and Hodgman 1974).
QPolygonF beside(const QPolygonF& shape, double y, bool below) {
  QPolygonF part;
  for (qsizetype i = 0; i < shape.size(); ++i) {
    const QPointF from = shape[i];
    const QPointF to = shape[(i + 1) % shape.size()];
    const bool from_in = below ? from.y() >= y : from.y() <= y;
    const bool to_in = below ? to.y() >= y : to.y() <= y;
    if (from_in) part << from;
    if (from_in != to_in) part << QPointF(from.x() + (to.x() - from.x()) * (y - from.y()) / (to.y() - from.y()), y);
  }
  return part;
}

}  // namespace

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
  for (const QCPDataRange& segment : getNonNanSegments(lines, keyAxis()->orientation())) {
    fillInStrips(*painter, getFillPolygon(lines, segment));
  }
}

void fillInStrips(QCPPainter& painter, const QRectF& area, const QColor& color) {
  const double height = isVector(painter) ? area.height() : stripHeight(painter);
  for (double top = area.top(); top < area.bottom(); top += height) {
    painter.fillRect(QRectF(area.left(), top, area.width(), std::min(height, area.bottom() - top)), color);
  }
}

void fillInStrips(QCPPainter& painter, const QPolygonF& shape) {
  const QRectF bounds = shape.boundingRect();
  if (isVector(painter)) {
    painter.drawPolygon(shape);
    return;
  }
  const double height = stripHeight(painter);
  for (double top = std::floor(bounds.top()); top < bounds.bottom(); top += height) {
    const QPolygonF strip = beside(beside(shape, top, true), top + height, false);
    if (strip.size() > 2) painter.drawPolygon(strip);
  }
}

}  // namespace tactus::workbench
