#include "app/workbench/kit/card.h"

#include <QPainter>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

Card::Card(QWidget* parent) : QFrame(parent) {}

void Card::setColors(const QColor& fill, const QColor& edge) {
  fill_ = fill;
  edge_ = edge;
  update();
}

void Card::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme::inLook(edge_.value_or(theme::border())), 1));
  painter.setBrush(theme::inLook(fill_.value_or(theme::card())));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), theme::kCornerRadius, theme::kCornerRadius);
}

}  // namespace tactus::workbench
