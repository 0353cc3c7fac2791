#include "app/workbench/tune/terms/vertex_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyle>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tactus::workbench {
namespace {

constexpr int kPositions = 10'000;  // finer than any screen

}  // namespace

VertexSlider::VertexSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(0, kPositions);
  setFocusPolicy(Qt::StrongFocus);
}

void VertexSlider::setEnds(double from, double to) {
  from_ = from;
  to_ = to;
}

void VertexSlider::setPlace(double place) {
  const double share = std::clamp((place - from_) / (to_ - from_), 0.0, 1.0);
  setValue(static_cast<int>(std::lround(share * kPositions)));
}

double VertexSlider::perPixel() const {
  const int room = width() - style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
  return (to_ - from_) / std::max(1, room);
}

bool VertexSlider::event(QEvent* event) {
  // A shortcut of the window must not take the key that cancels a drag.
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
      (dragging_ || stepping_)) {
    event->accept();
    return true;
  }
  return QSlider::event(event);
}

// The vertex follows the hand from where it is: a click beside the handle moves nothing.
void VertexSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  press_x_ = event->position().x();
  pressed_ = true;
  event->accept();
}

void VertexSlider::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return;
  if (!std::exchange(dragging_, true)) emit moveBegun();
  emit moved((event->position().x() - press_x_) * perPixel());
}

void VertexSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  pressed_ = false;
  if (std::exchange(dragging_, false)) emit moveEnded();
}

// The wheel scrolls the panel; it must not change the model by accident.
void VertexSlider::wheelEvent(QWheelEvent* event) { event->ignore(); }

void VertexSlider::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key == Qt::Key_Escape && (dragging_ || stepping_)) {
    pressed_ = dragging_ = stepping_ = false;
    emit moveCancelled();
  } else if ((key == Qt::Key_Left || key == Qt::Key_Right) && !dragging_) {
    stepping_ = true;
    emit stepped(key == Qt::Key_Right ? 1 : -1, event->modifiers().testFlag(Qt::ShiftModifier));
  } else if ((key == Qt::Key_PageUp || key == Qt::Key_PageDown) && !dragging_) {
    stepping_ = true;
    emit stepped(key == Qt::Key_PageUp ? 1 : -1, true);
  } else {
    QWidget::keyPressEvent(event);
  }
}

void VertexSlider::keyReleaseEvent(QKeyEvent* event) {
  if (!event->isAutoRepeat() && std::exchange(stepping_, false)) emit stepsEnded();
}

void VertexSlider::focusOutEvent(QFocusEvent* event) {
  // Whatever takes the keyboard away ends what it was moving.
  if (std::exchange(stepping_, false)) emit stepsEnded();
  QSlider::focusOutEvent(event);
}

}  // namespace tactus::workbench
