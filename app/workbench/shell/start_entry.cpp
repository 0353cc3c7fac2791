#include "app/workbench/shell/start_entry.h"

#include <QKeyEvent>
#include <QPainter>
#include <algorithm>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kEntryInset = theme::kGrid + theme::kGrid / 2;  // px, between edge and text
constexpr int kEntryWidth = 240;                              // px, the least

}  // namespace

StartEntry::StartEntry(const QString& name, const QString& note, QWidget* parent) : QAbstractButton(parent) {
  setText(name);
  setNote(note);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_Hover);
  setCursor(Qt::PointingHandCursor);
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void StartEntry::setNote(const QString& note) {
  note_ = note;
  setAccessibleName(text());
  setAccessibleDescription(note);
  updateGeometry();
  update();
}

void StartEntry::setPrimary(bool primary) {
  primary_ = primary;
  update();
}

void StartEntry::setOneLine(bool one_line) {
  one_line_ = one_line;
  updateGeometry();
}

QSize StartEntry::sizeHint() const { return {kEntryWidth, heightForWidth(kEntryWidth)}; }

int StartEntry::heightForWidth(int width) const { return noteRect(width).bottom() + 1 + theme::kGrid; }

// A recent file may have a long name, which is cut; a way to begin is read as a whole.
QRect StartEntry::nameRect(int width) const {
  const QFontMetrics metrics(theme::headingFont());
  const QRect room(kEntryInset, theme::kGrid, width - 2 * kEntryInset, 10'000);
  const int whole = metrics.boundingRect(room, Qt::TextWordWrap, text()).height();
  return {room.left(), room.top(), room.width(), one_line_ ? metrics.height() : std::max(whole, metrics.height())};
}

QRect StartEntry::noteRect(int width) const {
  const int top = nameRect(width).bottom() + 3;
  const QFontMetrics metrics(theme::smallFont());
  const QRect room(kEntryInset, top, width - 2 * kEntryInset, 10'000);
  if (note_.isEmpty()) return {room.left(), top - 2, room.width(), 0};
  if (one_line_) return {room.left(), top, room.width(), metrics.height()};
  return {room.left(), top, room.width(), metrics.boundingRect(room, Qt::TextWordWrap, note_).height()};
}

void StartEntry::keyPressEvent(QKeyEvent* event) {
  const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (!enters || event->isAutoRepeat()) return QAbstractButton::keyPressEvent(event);
  click();
}

void StartEntry::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor rest = primary_ ? theme::accent() : theme::card();
  const bool pointed = isEnabled() && (underMouse() || hasFocus());
  const QColor fill = !isEnabled() ? theme::window()
                      : isDown()   ? rest.darker(112)
                      : !pointed   ? rest
                      : primary_   ? rest.darker(106)
                                   : theme::window();
  painter.setPen(QPen(hasFocus() ? (primary_ ? theme::ink() : theme::accent())
                      : primary_ ? fill
                                 : theme::border(),
                      hasFocus() ? 2 : 1));
  painter.setBrush(fill);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), theme::kCornerRadius, theme::kCornerRadius);
  const QColor on_fill = primary_ && isEnabled() ? theme::inkOn(fill) : QColor();
  painter.setPen(on_fill.isValid() ? on_fill : isEnabled() ? theme::ink() : theme::mutedInk());
  painter.setFont(theme::headingFont());
  const QFontMetrics heading(painter.font());
  const QRect name = nameRect(width());
  if (one_line_) {
    painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter, heading.elidedText(text(), Qt::ElideRight, name.width()));
  } else {
    painter.drawText(name, Qt::TextWordWrap, text());
  }
  painter.setPen(on_fill.isValid() ? on_fill : theme::mutedInk());
  painter.setFont(theme::smallFont());
  const QRect place = noteRect(width());
  const QString note =
      one_line_ ? QFontMetrics(painter.font()).elidedText(note_, Qt::ElideMiddle, place.width()) : note_;
  painter.drawText(place, Qt::TextWordWrap, note);
}

}  // namespace tactus::workbench
