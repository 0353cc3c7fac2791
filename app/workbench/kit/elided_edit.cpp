#include "app/workbench/kit/elided_edit.h"

#include <QPainter>

namespace tactus::workbench {
namespace {

constexpr int kInside = 2;  // px between the edge and the letters, as in a line edit without a frame

}  // namespace

ElidedEdit::ElidedEdit(QWidget* parent) : QLineEdit(parent) { setFrame(false); }

void ElidedEdit::paintEvent(QPaintEvent* event) {
  const QRect room = rect().adjusted(kInside, 0, -kInside, 0);
  if (hasFocus() || fontMetrics().horizontalAdvance(text()) <= room.width()) {
    QLineEdit::paintEvent(event);
    return;
  }
  QPainter painter(this);
  painter.setPen(palette().color(isEnabled() ? QPalette::Normal : QPalette::Disabled, QPalette::Text));
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                   fontMetrics().elidedText(text(), Qt::ElideRight, room.width()));
}

}  // namespace tactus::workbench
