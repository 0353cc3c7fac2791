#include "app/workbench/feel/force_off_button.h"

#include <QPainter>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

// The red of the nurse's button (participant/kit/colors.h), in both looks; white on it has 8.2:1.
constexpr QColor kForceOffFill(0x9B, 0x1C, 0x1C);
constexpr int kForceOffHeight = 30;  // px, of the strip

}  // namespace

ForceOffButton::ForceOffButton(QWidget* parent) : QAbstractButton(parent) {
  setText(tr("Force off"));
  setAccessibleName(text());
  setToolTip(tr("Stop the force with the next tick, whatever has the keyboard (F12, or Esc outside a drag)"));
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QString ForceOffButton::keys() const { return tr("Esc · F12"); }

QSize ForceOffButton::sizeHint() const {
  return {QFontMetrics(theme::headingFont()).horizontalAdvance(text()) +
              QFontMetrics(theme::smallFont()).horizontalAdvance(keys()) + 4 * theme::kGrid,
          kForceOffHeight};
}

void ForceOffButton::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor fill = isDown() ? kForceOffFill.darker(130) : underMouse() ? kForceOffFill.darker(112) : kForceOffFill;
  painter.setPen(hasFocus() ? QPen(theme::ink(), 2) : QPen(Qt::NoPen));
  painter.setBrush(fill);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
  painter.setPen(Qt::white);
  const QRect inside = rect().adjusted(theme::kGrid + 4, 0, -theme::kGrid - 4, 0);
  painter.setFont(theme::headingFont());
  painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter, text());
  painter.setFont(theme::smallFont());
  painter.drawText(inside, Qt::AlignRight | Qt::AlignVCenter, keys());
}

}  // namespace tactus::workbench
