#include "app/workbench/plots/map_marks.h"

#include <QFontMetricsF>
#include <utility>

#include "app/workbench/theme.h"

namespace tactus::workbench {

ContourMarks::ContourMarks(QCustomPlot& plot) : QCPLayerable(&plot, QStringLiteral("main")) {}

void ContourMarks::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void ContourMarks::draw(QCPPainter* painter) {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QCPAxis* bottom = area->axis(QCPAxis::atBottom);
  const QCPAxis* left = area->axis(QCPAxis::atLeft);
  QColor color = Qt::white;  // on the colors of the map, whatever the theme
  color.setAlphaF(0.65F);
  painter->setPen(QPen(color, 1));
  for (const Line& line : lines_) {
    QVector<QLineF> pieces;
    pieces.reserve(static_cast<qsizetype>(line.pieces.size()));
    for (const QLineF& piece : line.pieces) {
      pieces << QLineF(bottom->coordToPixel(piece.x1()), left->coordToPixel(piece.y1()),
                       bottom->coordToPixel(piece.x2()), left->coordToPixel(piece.y2()));
    }
    painter->drawLines(pieces);
  }
}

// The overlay has a buffer of its own, so the cross moves without drawing the map again.
MapCross::MapCross(QCustomPlot& plot) : QCPLayerable(&plot, QStringLiteral("overlay")), font_(theme::smallFont()) {}

void MapCross::set(double x, double y, QString tag) {
  x_ = x;
  y_ = y;
  tag_ = std::move(tag);
}

void MapCross::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void MapCross::draw(QCPPainter* painter) {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QPointF place(area->axis(QCPAxis::atBottom)->coordToPixel(x_), area->axis(QCPAxis::atLeft)->coordToPixel(y_));
  QColor line = Qt::white;
  line.setAlphaF(0.9F);
  for (const QPen& pen : {QPen(theme::accent(), 2.6), QPen(line, 1)}) {
    painter->setPen(pen);
    painter->drawLine(QLineF(place.x(), area->top(), place.x(), area->bottom()));
    painter->drawLine(QLineF(area->left(), place.y(), area->right(), place.y()));
  }
  painter->setPen(QPen(Qt::white, 1.5));
  painter->setBrush(theme::accent());
  painter->drawEllipse(place, 4.5, 4.5);

  const QFontMetricsF metrics(font_);
  const double width = metrics.horizontalAdvance(tag_) + 12;
  const double height = metrics.height() + 6;
  const double left = place.x() + 8 + width <= area->right() ? place.x() + 8 : place.x() - 8 - width;
  const double top = place.y() - 8 - height >= area->top() ? place.y() - 8 - height : place.y() + 8;
  painter->setPen(Qt::NoPen);
  painter->setBrush(theme::accent());
  painter->drawRoundedRect(QRectF(left, top, width, height), 4, 4);
  painter->setPen(Qt::white);
  painter->setFont(font_);
  painter->drawText(QPointF(left + 6, top + height - 3 - metrics.descent()), tag_);
}

}  // namespace tactus::workbench
