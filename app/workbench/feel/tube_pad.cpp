#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/feel/feel_panel.h"

namespace tactus::workbench {
namespace {

constexpr double kFirstMm = -10;
constexpr double kLastMm = 150;  // a stroke of an arm's reach; more strokes go deeper
constexpr double kTickMm = 50;
constexpr double kKeyStepMm = 2;
constexpr double kShiftStepMm = 10;
constexpr int kMargin = 14;  // px, left and right
constexpr double kTubeY = 24;
constexpr double kTubeHeight = 8;
constexpr double kWidest = 120;  // px, more than half a number of the scale with its unit
constexpr double kHandRadius = 7;
constexpr double kDotSide = 9;

QColor lagColor() { return theme::expert(1); }

}  // namespace

TubePad::TubePad(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Hand on the tool"));
}

void TubePad::setReading(const Reading& reading) {
  if (reading == reading_) return;
  const bool other_cursor = reading.live != reading_.live;
  reading_ = reading;
  setToolTip(hint());
  if (other_cursor) setCursor(reading.live ? Qt::SizeHorCursor : Qt::ArrowCursor);
  update();
}

QSize TubePad::sizeHint() const {
  return {320, static_cast<int>(kTubeY) + 24 + (low_ ? 1 : 2) * QFontMetrics(theme::smallFont()).height()};
}

void TubePad::setLow(bool low) {
  low_ = low;
  updateGeometry();
  update();
}

double TubePad::xOf(double position_mm) const {
  const double share = (std::clamp(position_mm, kFirstMm, kLastMm) - kFirstMm) / (kLastMm - kFirstMm);
  return kMargin + share * (width() - 2 * kMargin);
}

double TubePad::positionAt(double x) const {
  const double share = (x - kMargin) / std::max(1, width() - 2 * kMargin);
  return std::clamp(kFirstMm + share * (kLastMm - kFirstMm), kFirstMm, kLastMm);
}

QString TubePad::hint() const {
  if (!reading_.running && reading_.armed) return tr("Armed: the recording begins with Start.");
  if (!reading_.running) return tr("Start, hold the button, push right.");
  if (reading_.replay) return tr("The recorded hand moves the tool.");
  if (!reading_.live && reading_.latch) return tr("Press once, push the device away.");
  if (!reading_.live) return tr("Hold the device, push it away.");
  if (reading_.latch && reading_.held) return tr("Push right; click or Space lets go.");
  if (reading_.latch) return tr("Click or Space, then push right.");
  if (reading_.held) return tr("Let go, go back left, push again.");
  return tr("Hold mouse or Space, push right.");
}

void TubePad::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(theme::smallFont());
  const double line = painter.fontMetrics().height();
  const bool lit = reading_.running;

  painter.setPen(QPen(hasFocus() ? theme::accent() : theme::border(), 1));
  painter.setBrush(theme::window());
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), theme::kCornerRadius, theme::kCornerRadius);

  // The scale along the axis.
  const double scale_y = kTubeY + kHandRadius + 5;
  painter.setPen(QPen(theme::border(), 1));
  painter.drawLine(QPointF(xOf(kFirstMm), scale_y), QPointF(xOf(kLastMm), scale_y));
  for (double mm = 0; mm <= kLastMm; mm += kTickMm) {
    painter.setPen(QPen(theme::border(), 1));
    painter.drawLine(QPointF(xOf(mm), scale_y), QPointF(xOf(mm), scale_y + 4));
    painter.setPen(theme::mutedInk());
    const QString number = mm == kLastMm ? quantityText(mm, "mm") : numberText(mm);
    const QRectF place(xOf(mm) - kWidest, scale_y + 5, mm == kLastMm ? kWidest + kMargin - 8 : 2 * kWidest, line);
    // With large text the last number, which has the unit, takes the place of the one before.
    const double last = painter.fontMetrics().horizontalAdvance(quantityText(kLastMm, "mm"));
    const bool covered =
        xOf(mm) + painter.fontMetrics().horizontalAdvance(number) / 2.0 > xOf(kLastMm) + kMargin - 8 - last;
    if (mm < kLastMm && covered) continue;
    painter.drawText(place, (mm == kLastMm ? Qt::AlignRight : Qt::AlignHCenter) | Qt::AlignTop, number);
  }

  // The tube up to the hand, and the hand on it.
  const double hand_x = xOf(reading_.hand_mm);
  const QColor tube = lit ? theme::accent() : theme::border();
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(tube.red(), tube.green(), tube.blue(), reading_.held ? 130 : 50));
  painter.drawRoundedRect(
      QRectF(QPointF(4, kTubeY - kTubeHeight / 2), QPointF(xOf(reading_.tube_mm), kTubeY + kTubeHeight / 2)), 3, 3);
  painter.setPen(QPen(tube, 2));
  painter.setBrush(reading_.held ? tube : theme::card());
  painter.drawEllipse(QPointF(hand_x, kTubeY), kHandRadius, kHandRadius);

  // What the cursor wants, and how far the tube lags behind.
  if (reading_.live) {
    const double target_x = xOf(reading_.target_mm);
    painter.setPen(QPen(lagColor(), 2));
    painter.drawLine(QPointF(target_x, kTubeY - 12), QPointF(target_x, kTubeY + 11));
    const double lag_mm = reading_.target_mm - reading_.tube_mm;
    if (reading_.held && std::abs(lag_mm) >= 0.5) {
      painter.setPen(QPen(lagColor(), 1.4, Qt::DotLine));
      painter.drawLine(QPointF(xOf(reading_.tube_mm), kTubeY), QPointF(target_x, kTubeY));
      const QString lag = tr("lag %1").arg(quantityText(lag_mm, "mm", 1));
      const double room = painter.fontMetrics().horizontalAdvance(lag) + 8;
      const double x = target_x + room + 8 < width() ? target_x + 6 : std::min(hand_x, target_x) - room - 8;
      painter.setPen(theme::isDark() ? lagColor().lighter(140) : lagColor().darker(130));
      painter.drawText(QRectF(x, 2, room, line), Qt::AlignLeft | Qt::AlignTop, lag);
    }
  }
  if (reading_.recorded_s || reading_.armed) paintRecording(painter);
  painter.setPen(theme::mutedInk());
  if (low_) {
    // How to begin is the one hint that finds room, beside the hand that rests.
    const double left = hand_x + 2 * kHandRadius;
    const double room = width() - left;
    const QString words = painter.fontMetrics().elidedText(hint(), Qt::ElideRight, static_cast<int>(room));
    if (!lit) painter.drawText(QRectF(left, kTubeY - line / 2, room, line), Qt::AlignLeft, words);
    return;
  }
  painter.drawText(QRectF(kMargin, height() - line - 4, width() - 2 * kMargin, line), Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(hint(), Qt::ElideRight, width() - 2 * kMargin));
}

// A red dot while a recording is in progress, a ring while one waits for Start.
void TubePad::paintRecording(QPainter& painter) const {
  const double line = painter.fontMetrics().height();
  const QString words = reading_.recorded_s ? tr("Recording %1 s").arg(*reading_.recorded_s) : tr("Armed");
  const QRectF dot(kMargin - 4, 2 + (line - kDotSide) / 2, kDotSide, kDotSide);
  painter.setPen(QPen(theme::errorInk(), 2));
  painter.setBrush(reading_.recorded_s ? QBrush(theme::errorInk()) : QBrush(Qt::NoBrush));
  painter.drawEllipse(dot);
  painter.setPen(theme::errorInk());
  painter.drawText(QPointF(dot.right() + 6, 2 + painter.fontMetrics().ascent()), words);
}

void TubePad::mouseMoveEvent(QMouseEvent* event) {
  if (reading_.live) emit targetMoved(positionAt(event->position().x()));
}

void TubePad::mousePressEvent(QMouseEvent* event) {
  if (!reading_.running || event->button() != Qt::LeftButton) return;
  if (reading_.live) emit targetMoved(positionAt(event->position().x()));
  pressed_ = true;
  emit gripped(true);
}

void TubePad::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  pressed_ = false;
  emit gripped(false);
}

// The release no longer reaches a widget.
void TubePad::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (std::exchange(pressed_, false)) emit gripped(false);
}

void TubePad::keyPressEvent(QKeyEvent* event) {
  const bool left = event->key() == Qt::Key_Left;
  if (!reading_.live || (!left && event->key() != Qt::Key_Right)) {
    QWidget::keyPressEvent(event);
    return;
  }
  const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? kShiftStepMm : kKeyStepMm;
  emit targetMoved(std::clamp(reading_.target_mm + (left ? -step : step), kFirstMm, kLastMm));
}

}  // namespace tactus::workbench
