#include "app/workbench/understand/curves/legend_chip.h"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kSwatch = 16;        // px
constexpr int kInside = 6;         // px between the edge of a chip and what is in it
constexpr int kLeastLetters = 10;  // of a name that is cut
constexpr double kOff = 0.35;

}  // namespace

LegendChip::LegendChip(LegendEntry look, const QString& tip, QWidget* parent)
    : QAbstractButton(parent), look_(std::move(look)) {
  setText(look_.name);
  if (!tip.isEmpty()) setToolTip(tr("Show or hide: %1").arg(tip));
  setFont(theme::smallFont());
  setCheckable(true);
  setFocusPolicy(Qt::TabFocus);
}

void LegendChip::setName(const QString& name) {
  if (name == text()) return;
  setText(name);
  updateGeometry();
}

void LegendChip::setBrief(const QString& brief) {
  brief_ = brief;
  update();
}

void LegendChip::setLook(LegendEntry look) {
  look_ = std::move(look);
  update();
}

QSize LegendChip::sizeHint() const {
  const QFontMetrics metrics(font());
  return {kSwatch + 3 * kInside + metrics.horizontalAdvance(text()), metrics.height() + 6};
}

QSize LegendChip::minimumSizeHint() const {
  const QSize whole = sizeHint();
  return {std::min(whole.width(), kSwatch + 3 * kInside + fontMetrics().averageCharWidth() * kLeastLetters),
          whole.height()};
}

void LegendChip::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (underMouse() || hasFocus()) {
    painter.setPen(hasFocus() ? QPen(theme::accent(), 1) : Qt::NoPen);
    painter.setBrush(theme::grid());
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  }
  painter.setOpacity(isChecked() ? 1 : kOff);
  const double middle = height() / 2.0;
  const QRectF swatch(kInside, middle - 5, kSwatch, 10);
  // The entry may have been made in the other look.
  QBrush fill = look_.fill;
  fill.setColor(theme::inLook(fill.color()));
  if (fill.style() != Qt::NoBrush) painter.fillRect(swatch, fill);
  QPen pen = look_.pen;
  pen.setColor(theme::inLook(pen.color()));
  pen.setWidthF(std::min(pen.widthF(), 4.0));
  painter.setPen(pen);
  painter.drawLine(QPointF(swatch.left(), middle), QPointF(swatch.right(), middle));
  if (look_.dots) {
    painter.setBrush(pen.color());
    painter.drawEllipse(swatch.center(), 2.2, 2.2);
  }
  painter.setOpacity(1);
  painter.setPen(isChecked() ? theme::ink() : theme::mutedInk());
  QFont words = font();
  words.setStrikeOut(!isChecked());
  painter.setFont(words);
  const QRect room = rect().adjusted(kSwatch + 2 * kInside, 0, 0, 0);
  const bool fits = QFontMetrics(words).horizontalAdvance(text()) <= room.width();
  const QString shown = fits || brief_.isEmpty() ? text() : brief_;
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                   QFontMetrics(words).elidedText(shown, Qt::ElideRight, room.width()));
}

void LegendChip::enterEvent(QEnterEvent* event) {
  update();
  QAbstractButton::enterEvent(event);
}

void LegendChip::leaveEvent(QEvent* event) {
  update();
  QAbstractButton::leaveEvent(event);
}

}  // namespace tactus::workbench
