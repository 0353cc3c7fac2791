#include "app/workbench/labs/rules/cell_paint.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/force_word.h"
#include "app/workbench/plot/term_colors.h"

namespace tactus::workbench {
namespace {

constexpr double kInset = 1.5;  // px
constexpr double kCellCorner = 3;
constexpr double kMarkPx = 8;

}  // namespace

void paintAskedCell(QPainter& painter, const QRectF& place, const AskedCell& cell, const fuzzy::Variable& output,
                    bool brief) {
  const QRectF inside = place.adjusted(kInset, kInset, -kInset, -kInset);
  if (!cell.asked) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(QBrush(theme::border(), Qt::BDiagPattern));
    painter.drawRoundedRect(inside, kCellCorner, kCellCorner);
  } else if (cell.word) {
    const QString word = labelOf(output.terms[*cell.word]);
    paintForceWord(painter, inside,
                   {brief ? initialsOf(word) : word, termFill(output, output.terms, *cell.word), cell.weight > 0});
  } else {
    paintNoWord(painter, inside);
  }
  if (!cell.corrected) return;
  QPainterPath fold(inside.topRight());
  fold.lineTo(inside.right() - kMarkPx, inside.top());
  fold.lineTo(inside.right(), inside.top() + kMarkPx);
  fold.closeSubpath();
  painter.fillPath(fold, theme::accent());
}

QColor distanceColor(double noticeable) {
  // Full color at three just-noticeable differences: beyond that everybody feels it.
  const double share = std::clamp(noticeable / 3, 0.0, 1.0);
  QColor color = theme::warningInk();
  color.setAlphaF(static_cast<float>(0.06 + 0.64 * share));
  return theme::onCard(color);
}

void paintConflictCell(QPainter& painter, const QRectF& place, const elicitation::CellConflict* conflict) {
  const QRectF inside = place.adjusted(kInset, kInset, -kInset, -kInset);
  const auto has_word = [](const std::string& word) { return !word.empty(); };
  if (conflict == nullptr || std::count_if(conflict->words.begin(), conflict->words.end(), has_word) < 2) {
    painter.setPen(theme::mutedInk());
    painter.drawText(inside, Qt::AlignCenter, QStringLiteral("–"));
    return;
  }
  const QColor fill = distanceColor(conflict->rms_noticeable);
  painter.setPen(Qt::NoPen);
  painter.setBrush(fill);
  painter.drawRoundedRect(inside, kCellCorner, kCellCorner);
  if (conflict->rms_noticeable > 1) {
    painter.setPen(QPen(theme::warningInk(), 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(inside, kCellCorner, kCellCorner);
  }
  painter.setPen(theme::inkOn(fill));
  painter.drawText(inside, Qt::AlignCenter, QString::number(conflict->rms_n, 'f', 2));
}

}  // namespace tactus::workbench
