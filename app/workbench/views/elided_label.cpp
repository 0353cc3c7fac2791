#include "app/workbench/views/elided_label.h"

#include <algorithm>

namespace tactus::workbench {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void ElidedLabel::setFullText(const QString& text) {
  if (text == full_) return;
  full_ = text;
  elide();
  updateGeometry();
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
  const QString shown = fontMetrics().elidedText(full_, Qt::ElideRight, width() - std::max(0, indent()));
  setText(shown);
  setToolTip(shown == full_ ? QString() : full_);
}

}  // namespace tactus::workbench
