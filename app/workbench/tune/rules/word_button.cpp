#include "app/workbench/tune/rules/word_button.h"

#include <QPainter>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/force_word.h"

namespace tactus::workbench {

WordButton::WordButton(const QString& word, const QString& key, std::optional<QColor> color, QWidget* parent)
    : QAbstractButton(parent), key_(key), color_(color) {
  setText(word);
  setAccessibleName(word);
  setToolTip(key.isEmpty() ? tr("Answer %1").arg(word) : tr("Answer %1 (key %2)").arg(word, key));
  setFont(theme::smallFont());
  // The keys stay with the grids.
  setFocusPolicy(Qt::NoFocus);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  setAttribute(Qt::WA_Hover);
}

void WordButton::setMarked(bool marked) {
  if (marked == marked_) return;
  marked_ = marked;
  update();
}

QSize WordButton::sizeHint() const {
  return {fontMetrics().horizontalAdvance(key_ + QStringLiteral("  ") + text()) + 2 * theme::kGrid,
          fontMetrics().height() + 10};
}

void WordButton::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font());
  painter.setOpacity(isEnabled() ? (isDown() ? 0.75 : 1.0) : 0.4);
  const QRectF place = QRectF(rect()).adjusted(2, 2, -2, -2);
  const QString shown = fontMetrics().elidedText(key_.isEmpty() ? text() : key_ + QStringLiteral("  ") + text(),
                                                 Qt::ElideRight, static_cast<int>(place.width()) - 6);
  if (color_) {
    paintForceWord(painter, place, {shown, *color_});
  } else {
    paintNoWord(painter, place);
    painter.setPen(theme::mutedInk());
    painter.drawText(place, Qt::AlignCenter, shown);
  }
  if (!marked_ && !(underMouse() && isEnabled())) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(marked_ ? theme::ink() : theme::accent(), 2));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 5, 5);
}

}  // namespace tactus::workbench
