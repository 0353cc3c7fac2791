#include "app/workbench/help/tour_frame.h"

#include <QPainter>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

TourFrame::TourFrame(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
}

void TourFrame::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme::accent(), 3));
  painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), theme::kCornerRadius, theme::kCornerRadius);
}

}  // namespace tactus::workbench
