#include "app/workbench/kit/lock_button.h"

#include <QPainter>
#include <QPainterPath>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kLockWidth = 16;  // px
constexpr int kHeight = 24;     // px

}  // namespace

LockButton::LockButton(QWidget* parent) : QAbstractButton(parent) {
  setCheckable(true);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QSize LockButton::sizeHint() const { return {kLockWidth, kHeight}; }

void LockButton::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool strong = isChecked() || underMouse() || hasFocus();
  QColor color = isChecked() ? theme::ink() : theme::mutedInk();
  color.setAlphaF(strong ? 1.0F : 0.35F);

  const QRectF body(width() / 2.0 - 4.5, height() / 2.0 - 1, 9, 7);
  QPainterPath shackle;
  const double top = body.top() - 4.5;
  const double side = isChecked() ? body.right() - 2 : body.right() + 1.5;
  // Open: the shackle has left its hole on the right and stands a little higher.
  const double lift = isChecked() ? 0 : 1.5;
  shackle.moveTo(body.left() + 2, body.top());
  shackle.lineTo(body.left() + 2, top + 2 - lift);
  shackle.quadTo(QPointF(body.left() + 2, top - lift), QPointF((body.left() + 2 + side) / 2, top - lift));
  shackle.quadTo(QPointF(side, top - lift), QPointF(side, top + 2 - lift));
  if (isChecked()) shackle.lineTo(side, body.top());
  painter.setPen(QPen(color, 1.5));
  painter.drawPath(shackle);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawRoundedRect(body, 1.5, 1.5);
  if (hasFocus()) {
    painter.setPen(QPen(theme::accent(), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
  }
}

}  // namespace tactus::workbench
