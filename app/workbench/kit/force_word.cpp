#include "app/workbench/kit/force_word.h"

#include <QPainter>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"

namespace tactus::workbench {
namespace {

constexpr double kCorner = 4;  // px
constexpr double kBar = 5;     // px, width of the bar of the strength
constexpr double kBadge = 13;  // px

// A level at the left edge, as high as the rule is strong.
void paintStrength(QPainter& painter, const QRectF& place, const QColor& ink, double strength) {
  const QRectF track(place.left() + 4, place.top() + 4, kBar, place.height() - 8);
  const double height = std::max(kBar, track.height() * strength);
  QColor pale = ink;
  pale.setAlphaF(0.28F);
  painter.setPen(Qt::NoPen);
  painter.setBrush(pale);
  painter.drawRoundedRect(track, kBar / 2, kBar / 2);
  painter.setBrush(ink);
  painter.drawRoundedRect(QRectF(track.left(), track.bottom() - height, kBar, height), kBar / 2, kBar / 2);
}

void paintConflict(QPainter& painter, const QRectF& place) {
  const QRectF badge(place.right() - kBadge - 2, place.top() + 2, kBadge, kBadge);
  painter.setPen(QPen(theme::warningInk(), 1));
  painter.setBrush(theme::warningFill());
  painter.drawEllipse(badge);
  QFont font = painter.font();
  const QFont before = font;
  font.setBold(true);
  font.setPixelSize(10);
  painter.setFont(font);
  painter.drawText(badge, Qt::AlignCenter, QStringLiteral("!"));
  painter.setFont(before);
}

}  // namespace

void paintForceWord(QPainter& painter, const QRectF& place, const ForceWord& word) {
  const QColor ink = word.enabled ? theme::inkOn(word.color) : theme::mutedInk();
  QColor fill = word.color;
  if (!word.enabled) fill.setAlphaF(0.12F);
  painter.setPen(word.enabled ? Qt::NoPen : QPen(word.color, 1));
  painter.setBrush(fill);
  painter.drawRoundedRect(place.adjusted(0.5, 0.5, -0.5, -0.5), kCorner, kCorner);

  const bool weighted = word.weight < 1;
  const QString weight = QStringLiteral("×") + numberText(word.weight, 2);
  const QFontMetricsF metrics(painter.font());
  const bool acts = word.strength > 0;
  // In a low place the mark of a conflict would stand on the word.
  const bool beside = word.conflict && place.height() < metrics.height() + kBadge;
  const QRectF words = place.adjusted(acts ? kBar + 5 : 3, 0, beside ? -kBadge - 3 : -3, 0);
  const double room = words.width();
  QString text = brokenLabel(word.word, room, metrics);
  if (text.contains(QChar(0x2026)) || metrics.height() * (text.count(QLatin1Char('\n')) + 1) > place.height()) {
    text = initialsOf(word.word);
  }
  // The weight stands behind the word or, where there is no room, below it.
  if (weighted) {
    const bool one_line = !text.contains(QLatin1Char('\n'));
    const bool behind = one_line && metrics.horizontalAdvance(text + QLatin1Char(' ') + weight) <= room;
    if (!one_line) text = metrics.elidedText(word.word, Qt::ElideRight, room);
    text += (behind ? QLatin1Char(' ') : QLatin1Char('\n')) + weight;
  }
  QFont font = painter.font();
  const QFont before = font;
  font.setStrikeOut(!word.enabled);
  painter.setFont(font);
  painter.setPen(ink);
  painter.drawText(words, Qt::AlignCenter, text);
  painter.setFont(before);
  if (acts) paintStrength(painter, place, ink, word.strength);
  if (word.conflict) paintConflict(painter, place);
}

void paintNoWord(QPainter& painter, const QRectF& place) {
  painter.setPen(QPen(theme::border(), 1, Qt::DashLine));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(place.adjusted(0.5, 0.5, -0.5, -0.5), kCorner, kCorner);
}

}  // namespace tactus::workbench
