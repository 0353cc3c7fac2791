#include "app/workbench/tune/history/history_delegate.h"

#include <QApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "app/workbench/base/theme.h"
#include "app/workbench/tune/history/history_model.h"

namespace tactus::workbench {
namespace {

using Place = editing::HistoryRow::Place;

constexpr int kLevelWidth = 2 * theme::kGrid;  // px
constexpr int kMostLevels = 6;                 // deeper branches stand below each other
constexpr int kDotRadius = 4;
constexpr double kBadgeShare = 0.45;  // of the width of a row, at most

int levelOf(const editing::HistoryRow& row) { return static_cast<int>(std::min<std::size_t>(row.level, kMostLevels)); }

int treeWidth(const editing::HistoryRow& row) { return theme::kGrid + (levelOf(row) + 1) * kLevelWidth; }

struct Badge {
  QString text;
  QColor ink;
  QColor fill;
};

}  // namespace

HistoryDelegate::HistoryDelegate(const HistoryModel& model, QObject* parent)
    : QStyledItemDelegate(parent), model_(model) {}

QSize HistoryDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const {
  const int lines = option.fontMetrics.height() + QFontMetrics(theme::smallFont()).height();
  return {option.fontMetrics.averageCharWidth() * 20, lines + theme::kGrid};
}

void HistoryDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const editing::HistoryRow& row = model_.row(index.row());
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  QColor fill = theme::accent();
  const bool under_mouse = option.state.testFlag(QStyle::State_MouseOver);
  if (row.place == Place::kCurrent || under_mouse) {
    fill.setAlphaF(row.place == Place::kCurrent ? 0.14F : 0.07F);
    painter->setPen(Qt::NoPen);
    painter->setBrush(fill);
    painter->drawRoundedRect(option.rect.adjusted(0, 1, 0, -1), 4, 4);
  }
  if (option.state.testFlag(QStyle::State_HasFocus)) {
    painter->setPen(theme::accent());
    painter->setBrush(Qt::NoBrush);
    painter->drawRoundedRect(QRectF(option.rect).adjusted(0.5, 1.5, -0.5, -1.5), 4, 4);
  }
  paintTree(*painter, option.rect, index.row());

  const bool behind = row.place == Place::kUndone || row.place == Place::kBranch;
  const QRect inside = option.rect.adjusted(treeWidth(row), 4, -theme::kGrid, -4);
  QFont font = option.font;
  if (row.place == Place::kCurrent) font.setWeight(QFont::DemiBold);
  const QFontMetrics metrics(font);
  QRect first(inside.topLeft(), QSize(inside.width(), metrics.height()));
  first.setRight(first.right() - paintBadges(*painter, first, index));
  painter->setFont(font);
  painter->setPen(behind ? theme::mutedInk() : theme::ink());
  painter->drawText(first, Qt::AlignLeft | Qt::AlignVCenter,
                    metrics.elidedText(index.data().toString(), Qt::ElideRight, first.width()));
  const QRect second(inside.left(), inside.top() + metrics.height(), inside.width(),
                     inside.height() - metrics.height());
  painter->setFont(theme::smallFont());
  painter->setPen(theme::mutedInk());
  painter->drawText(second, Qt::AlignLeft | Qt::AlignVCenter,
                    painter->fontMetrics().elidedText(index.data(HistoryModel::kEffectRole).toString(), Qt::ElideRight,
                                                      second.width()));
  painter->restore();
}

void HistoryDelegate::paintTree(QPainter& painter, const QRect& area, int row_number) const {
  const editing::HistoryRow& row = model_.row(row_number);
  const int level = levelOf(row);
  const auto x = [&](int of) { return area.left() + theme::kGrid + of * kLevelWidth + kDotRadius + 0.5; };
  const QPointF dot(x(level), area.top() + 4 + QFontMetrics(QApplication::font()).height() / 2.0);
  const double top = area.top();
  const double bottom = area.bottom() + 1;
  painter.setPen(QPen(theme::border(), 1.5));
  painter.setBrush(Qt::NoBrush);
  // The lines beside a branch continue below it.
  for (int outer = 0; outer < level; ++outer) painter.drawLine(QPointF(x(outer), top), QPointF(x(outer), bottom));
  if (row.starts && level > 0) {
    QPainterPath bend(QPointF(x(level - 1), top));
    bend.quadTo(QPointF(x(level - 1), dot.y()), dot);
    painter.drawPath(bend);
  } else if (!row.starts) {
    painter.drawLine(QPointF(dot.x(), top), dot);
  }
  if (row.goes_on) painter.drawLine(dot, QPointF(dot.x(), bottom));

  const bool behind = row.place == Place::kUndone || row.place == Place::kBranch;
  painter.setPen(QPen(behind ? theme::mutedInk() : theme::accent(), 1.5));
  painter.setBrush(row.place == Place::kCurrent ? theme::accent() : theme::card());
  const double radius = row.place == Place::kCurrent ? kDotRadius + 0.5 : kDotRadius - 0.5;
  painter.drawEllipse(dot, radius, radius);
}

int HistoryDelegate::paintBadges(QPainter& painter, const QRect& line, const QModelIndex& index) const {
  std::vector<Badge> badges;
  for (const QString& who : index.data(HistoryModel::kSignOffsRole).toStringList()) {
    badges.push_back({QStringLiteral("✓ ") + who, theme::card(), theme::accent()});
  }
  for (const QString& name : index.data(HistoryModel::kSnapshotsRole).toStringList()) {
    badges.push_back({name, theme::warningInk(), theme::warningFill()});
  }
  if (badges.empty()) return 0;
  painter.setFont(theme::smallFont());
  const QFontMetrics metrics(theme::smallFont());
  const int most = static_cast<int>(line.width() * kBadgeShare);
  int used = 0;
  for (auto badge = badges.rbegin(); badge != badges.rend(); ++badge) {
    const int room = most - used - 2 * theme::kGrid;
    if (room < 4 * theme::kGrid) break;
    const QString shown = metrics.elidedText(badge->text, Qt::ElideRight, room);
    const int width = metrics.horizontalAdvance(shown) + 2 * theme::kGrid;
    const QRect pill(line.right() - used - width, line.top(), width, line.height());
    painter.setPen(Qt::NoPen);
    painter.setBrush(badge->fill);
    painter.drawRoundedRect(pill, pill.height() / 2.0, pill.height() / 2.0);
    painter.setPen(badge->ink);
    painter.drawText(pill, Qt::AlignCenter, shown);
    used += width + 4;
  }
  return used + 4;
}

}  // namespace tactus::workbench
