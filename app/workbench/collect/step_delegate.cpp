#include "app/workbench/collect/step_delegate.h"

#include <QPainter>
#include <QPainterPath>

#include "app/workbench/base/theme.h"
#include "app/workbench/collect/participant_table.h"
#include "app/workbench/collect/step_words.h"

namespace tactus::workbench {
namespace {

constexpr int kMark = 16;  // px
constexpr int kRow = 7 * theme::kGrid;

void paintTick(QPainter& painter, const QRectF& mark) {
  QPainterPath tick;
  tick.moveTo(mark.left() + 0.25 * kMark, mark.top() + 0.52 * kMark);
  tick.lineTo(mark.left() + 0.44 * kMark, mark.top() + 0.70 * kMark);
  tick.lineTo(mark.left() + 0.76 * kMark, mark.top() + 0.32 * kMark);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme::card(), 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(tick);
}

// Full: done; a share of a pie: partly; an empty ring: open; a bar: left out; an arrow: imported.
void paintMark(QPainter& painter, const StepState& state, const QRectF& mark) {
  const QColor ink = theme::accent();
  painter.setPen(QPen(state.word == StepWord::kOpen ? theme::mutedInk() : ink, 1.6));
  painter.setBrush(Qt::NoBrush);
  const QPointF center = mark.center();
  switch (state.word) {
    case StepWord::kNotPart:
      painter.setPen(QPen(theme::border().darker(120), 1.6, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(center - QPointF(3, 0), center + QPointF(3, 0));
      break;
    case StepWord::kOpen:
      painter.drawEllipse(mark.adjusted(1, 1, -1, -1));
      break;
    case StepWord::kPartly: {
      painter.drawEllipse(mark.adjusted(1, 1, -1, -1));
      const double share = state.share.wanted > 0 ? static_cast<double>(state.share.done) / state.share.wanted : 0.5;
      painter.setPen(Qt::NoPen);
      painter.setBrush(ink);
      painter.drawPie(mark.adjusted(3, 3, -3, -3), 90 * 16, -static_cast<int>(share * 360 * 16));
      break;
    }
    case StepWord::kDone:
      painter.setBrush(ink);
      painter.drawEllipse(mark.adjusted(0.5, 0.5, -0.5, -0.5));
      paintTick(painter, mark);
      break;
    case StepWord::kSkipped:
      painter.setPen(QPen(theme::mutedInk(), 1.6, Qt::SolidLine, Qt::RoundCap));
      painter.drawEllipse(mark.adjusted(1, 1, -1, -1));
      painter.drawLine(center - QPointF(3.5, 0), center + QPointF(3.5, 0));
      break;
    case StepWord::kUnknown:
      painter.drawText(mark, Qt::AlignCenter, QStringLiteral("?"));
      break;
    case StepWord::kGiven:
      painter.drawEllipse(mark.adjusted(1, 1, -1, -1));
      painter.drawLine(center - QPointF(0, 4), center + QPointF(0, 3.5));
      painter.drawLine(center + QPointF(0, 3.5), center + QPointF(-3, 0.5));
      painter.drawLine(center + QPointF(0, 3.5), center + QPointF(3, 0.5));
      break;
  }
}

void paintStep(QPainter& painter, const StepState& state, const QRect& cell, const QColor& ink) {
  const QFont font = theme::smallFont();
  const QString word = stateText(state);
  const int text_height = word.isEmpty() ? 0 : QFontMetrics(font).height() + 2;
  const int top = cell.center().y() - (kMark + text_height) / 2;
  paintMark(painter, state, QRectF(cell.center().x() - kMark / 2, top, kMark, kMark));
  painter.setPen(ink);
  painter.setFont(font);
  painter.drawText(QRect(cell.left(), top + kMark + 2, cell.width(), text_height), Qt::AlignHCenter | Qt::AlignTop,
                   word);
}

void paintCode(QPainter& painter, const ParticipantRow& row, const QRect& cell, const QColor& ink) {
  const QRect inside = cell.adjusted(2 * theme::kGrid, 0, -theme::kGrid, 0);
  const QFont name = theme::headingFont();
  const int height = QFontMetrics(name).height();
  const QFont badge = theme::smallFont();
  const bool marked = row.simulated || row.virtual_device;
  const int badge_height = marked ? QFontMetrics(badge).height() + 4 : 0;
  const int top = inside.center().y() - (height + (marked ? badge_height + 2 : 0)) / 2;
  painter.setFont(name);
  painter.setPen(ink);
  const QString code = QFontMetrics(name).elidedText(row.code, Qt::ElideRight, inside.width());
  painter.drawText(QRect(inside.left(), top, inside.width(), height), Qt::AlignLeft | Qt::AlignVCenter, code);
  if (!marked) return;
  const QString word = row.simulated ? ParticipantTable::tr("SIMULATED") : ParticipantTable::tr("VIRTUAL");
  const QRect box(inside.left(), top + height + 2, QFontMetrics(badge).horizontalAdvance(word) + theme::kGrid,
                  badge_height);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::warningFill());
  painter.drawRoundedRect(box, 4, 4);
  painter.setFont(badge);
  painter.setPen(theme::warningInk());
  painter.drawText(box, Qt::AlignCenter, word);
}

}  // namespace

void StepDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const auto* const table = qobject_cast<const ParticipantTable*>(index.model());
  if (table == nullptr) return;
  const ParticipantRow& row = table->participant(index.row());
  const bool selected = option.state.testFlag(QStyle::State_Selected);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  if (selected) {
    QColor fill = theme::accent();
    fill.setAlphaF(0.12F);
    painter->fillRect(option.rect, theme::onCard(fill));
    if (index.column() == ParticipantTable::kCode) {
      painter->fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())), theme::accent());
    }
  }
  painter->setPen(QPen(theme::grid(), 1));
  painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
  if (const auto step = ParticipantTable::stepOf(index.column())) {
    const bool is_next = row.next == step && !row.stopped && row.trouble.isEmpty();
    paintStep(*painter, row.at(*step), option.rect, is_next ? theme::ink() : theme::mutedInk());
  } else if (index.column() == ParticipantTable::kCode) {
    paintCode(*painter, row, option.rect, theme::ink());
  } else {
    const bool next = index.column() == ParticipantTable::kNext;
    const bool warns = next && (row.stopped || !row.trouble.isEmpty());
    painter->setFont(next ? theme::headingFont() : theme::smallFont());
    painter->setPen(warns ? theme::warningInk() : next ? theme::ink() : theme::mutedInk());
    const QRect inside = option.rect.adjusted(theme::kGrid, 0, -theme::kGrid, 0);
    painter->drawText(inside, Qt::AlignLeft | Qt::AlignVCenter,
                      painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, inside.width()));
  }
  if (option.state.testFlag(QStyle::State_HasFocus)) {
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(theme::accent(), 1.5));
    painter->drawRect(QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -2.5));
  }
  painter->restore();
}

QSize StepDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  return {QStyledItemDelegate::sizeHint(option, index).width(), kRow};
}

}  // namespace tactus::workbench
