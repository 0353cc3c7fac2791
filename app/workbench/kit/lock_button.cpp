#include "app/workbench/kit/lock_button.h"

#include <QPainter>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/lock_picture.h"

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
  drawLock(painter, QPointF(width() / 2.0, height() / 2.0), color, isChecked());
  if (hasFocus()) {
    painter.setPen(QPen(theme::accent(), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
  }
}

}  // namespace tactus::workbench
