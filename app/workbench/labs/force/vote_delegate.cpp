#include "app/workbench/labs/force/vote_delegate.h"

#include <QPainter>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/force_word.h"
#include "app/workbench/labs/force/vote_table.h"

namespace tactus::workbench {
namespace {

constexpr double kGap = 3;  // px around what is painted
constexpr double kCorner = 4;

}  // namespace

VoteDelegate::VoteDelegate(const VoteTable& votes, QObject* parent) : QStyledItemDelegate(parent), votes_(votes) {}

void VoteDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const int column = index.column();
  const bool is_word = column >= VoteTable::kFirstWord && column < votes_.winnerColumn();
  if (!is_word && column != votes_.winnerColumn()) {
    QStyledItemDelegate::paint(painter, option, index);
    return;
  }
  QStyleOptionViewItem ground = option;
  initStyleOption(&ground, index);
  ground.text.clear();
  QStyledItemDelegate::paint(painter, ground, QModelIndex());
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setFont(option.font);
  const QRectF place = QRectF(option.rect).adjusted(kGap, kGap, -kGap, -kGap);
  const auto& term = votes_.step(index.row()).term;
  if (is_word) {
    paintVotes(*painter, place, index);
  } else if (term) {
    const auto count = static_cast<std::size_t>(votes_.words());
    paintForceWord(*painter, place, {index.data().toString(), theme::force(*term, count)});
  }
  painter->restore();
}

void VoteDelegate::paintVotes(QPainter& painter, const QRectF& place, const QModelIndex& index) const {
  const auto word = static_cast<std::size_t>(index.column() - VoteTable::kFirstWord);
  const QColor color = theme::force(word, static_cast<std::size_t>(votes_.words()));
  const double share = index.data(VoteTable::kShareRole).toDouble();
  const bool wins = index.data(VoteTable::kWinsRole).toBool();
  if (share > 0) {
    QColor fill = color;
    fill.setAlphaF(0.35F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::onCard(fill));
    painter.drawRoundedRect(QRectF(place.left(), place.top(), place.width() * share, place.height()), kCorner, kCorner);
  }
  if (wins) {
    painter.setPen(QPen(theme::readableLine(color), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(place.adjusted(1, 1, -1, -1), kCorner, kCorner);
  }
  QFont font = painter.font();
  font.setBold(wins);
  painter.setFont(font);
  painter.setPen(share > 0 ? theme::ink() : theme::mutedInk());
  painter.drawText(place, Qt::AlignCenter, index.data().toString());
}

}  // namespace tactus::workbench
