#include "app/workbench/kit/elided_label.h"

#include <algorithm>

namespace tactus::workbench {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void ElidedLabel::setFullText(const QString& text, const QString& brief) {
  if (text == full_ && brief == brief_) return;
  full_ = text;
  brief_ = brief;
  elide();
  updateGeometry();
}

void ElidedLabel::setHint(const QString& hint) {
  hint_ = hint;
  elide();
}

QSize ElidedLabel::minimumSizeHint() const { return {1, QLabel::sizeHint().height()}; }

QSize ElidedLabel::sizeHint() const {
  return {fontMetrics().horizontalAdvance(full_) + std::max(0, indent()) + 2, QLabel::sizeHint().height()};
}

void ElidedLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  elide();
}

void ElidedLabel::elide() {
  const int room = width() - std::max(0, indent());
  const bool fits = fontMetrics().horizontalAdvance(full_) <= room;
  const QString& text = fits || brief_.isEmpty() ? full_ : brief_;
  const QString shown = fontMetrics().elidedText(text, Qt::ElideRight, room);
  setText(shown);
  QStringList tip;
  if (shown != full_) tip << full_;
  if (!hint_.isEmpty()) tip << hint_;
  setToolTip(tip.join(QLatin1Char('\n')));
}

}  // namespace tactus::workbench
