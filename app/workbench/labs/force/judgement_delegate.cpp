#include "app/workbench/labs/force/judgement_delegate.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/force_word.h"
#include "app/workbench/labs/force/judgement_grid.h"

namespace tactus::workbench {
namespace {

constexpr double kWordGap = 2;  // px around what is painted
constexpr double kFold = 9;     // px, the corner of a corrected judgement

using Judged = study::ForceJudgement::Kind;

void paintOne(QPainter& painter, const QRectF& place, const session::JudgedForce& judged,
              const fuzzy::Variable& words) {
  const session::JudgedWord word = judgedWord(judged.record);
  const QString label = judgedText(words, word);
  QColor color;
  for (std::size_t i = 0; i < words.terms.size(); ++i) {
    if (word.kind == Judged::kTerm && words.terms[i].id == word.term) color = theme::force(i, words.terms.size());
  }
  if (color.isValid()) {
    paintForceWord(painter, place, {label, color, judged.counts});
  } else {
    paintNoWord(painter, place);
    painter.setPen(theme::mutedInk());
    painter.drawText(place.adjusted(4, 0, -4, 0), Qt::AlignCenter | Qt::TextWordWrap,
                     word.kind == Judged::kNoAnswer ? QStringLiteral("–") : label);
  }
  if (judged.before.empty()) return;
  QPainterPath fold(place.topRight());
  fold.lineTo(place.right() - kFold, place.top());
  fold.lineTo(place.right(), place.top() + kFold);
  fold.closeSubpath();
  painter.fillPath(fold, theme::accent());
}

}  // namespace

JudgementDelegate::JudgementDelegate(const JudgementGrid& grid, QObject* parent)
    : QStyledItemDelegate(parent), grid_(grid) {}

void JudgementDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyledItemDelegate::paint(painter, option, QModelIndex());
  const auto judgements = grid_.at(index);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setFont(option.font);
  const QRectF place = QRectF(option.rect).adjusted(kWordGap, kWordGap, -kWordGap, -kWordGap);
  const double width = place.width() / static_cast<double>(std::max<std::size_t>(1, judgements.size()));
  for (std::size_t i = 0; i < judgements.size(); ++i) {
    const QRectF part(place.left() + width * static_cast<double>(i), place.top(), width, place.height());
    paintOne(*painter, judgements.size() > 1 ? part.adjusted(0, 0, -1, 0) : part, *judgements[i], grid_.words());
  }
  // The style paints the ground of a selection; the words would hide it.
  if (option.state.testFlag(QStyle::State_Selected)) {
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(theme::ink(), 2));
    painter->drawRoundedRect(place, 4, 4);
  }
  painter->restore();
}

}  // namespace tactus::workbench
