#include "app/workbench/kit/primary_button.h"

#include <QPainter>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

PrimaryButton::PrimaryButton(const QString& text, QWidget* parent) : QPushButton(text, parent) {
  setFont(theme::headingFont());
  setAttribute(Qt::WA_Hover);
}

QSize PrimaryButton::sizeHint() const {
  const QFontMetrics metrics(font());
  return {metrics.size(Qt::TextShowMnemonic, text()).width() + 5 * theme::kGrid, 4 * theme::kGrid + 4};
}

void PrimaryButton::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor fill = !isEnabled() ? theme::border() : theme::accent();
  const QRectF shape = QRectF(rect()).adjusted(2, 2, -2, -2);
  painter.setPen(Qt::NoPen);
  painter.setBrush(isDown() ? fill.darker(120) : underMouse() && isEnabled() ? fill.darker(108) : fill);
  painter.drawRoundedRect(shape, 6, 6);
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme::ink(), 1.5));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.75, 0.75, -0.75, -0.75), 7, 7);
  }
  painter.setPen(isEnabled() ? theme::inkOn(fill) : theme::mutedInk());
  painter.drawText(rect(), Qt::AlignCenter | Qt::TextShowMnemonic, text());
}

}  // namespace tactus::workbench
