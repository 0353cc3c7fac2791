#include "app/workbench/kit/lock_picture.h"

#include <QPainter>
#include <QPainterPath>

namespace tactus::workbench {

void drawLock(QPainter& painter, const QPointF& center, const QColor& color, bool closed) {
  const QRectF body(center.x() - 4.5, center.y() - 1, 9, 7);
  QPainterPath shackle;
  const double top = body.top() - 4.5;
  const double side = closed ? body.right() - 2 : body.right() + 1.5;
  // Open: the shackle has left its hole on the right and stands a little higher.
  const double lift = closed ? 0 : 1.5;
  shackle.moveTo(body.left() + 2, body.top());
  shackle.lineTo(body.left() + 2, top + 2 - lift);
  shackle.quadTo(QPointF(body.left() + 2, top - lift), QPointF((body.left() + 2 + side) / 2, top - lift));
  shackle.quadTo(QPointF(side, top - lift), QPointF(side, top + 2 - lift));
  if (closed) shackle.lineTo(side, body.top());
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(color, 1.5));
  painter.drawPath(shackle);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawRoundedRect(body, 1.5, 1.5);
}

QPixmap lockPicture(const QColor& color, qreal dots) {
  constexpr int kSize = 16;  // px
  QPixmap picture(qRound(kSize * dots), qRound(kSize * dots));
  picture.setDevicePixelRatio(dots);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  drawLock(painter, QPointF(kSize / 2.0, kSize / 2.0), color, true);
  return picture;
}

}  // namespace tactus::workbench
