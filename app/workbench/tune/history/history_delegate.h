// Paints a row of the history: its place in the tree, the change, the effect on the force, and its badges.
#pragma once

#include <QStyledItemDelegate>

namespace tactus::workbench {

class HistoryModel;

class HistoryDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  explicit HistoryDelegate(const HistoryModel& model, QObject* parent = nullptr);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  void paintTree(QPainter& painter, const QRect& area, int row) const;
  int paintBadges(QPainter& painter, const QRect& line, const QModelIndex& index) const;

  const HistoryModel& model_;
};

}  // namespace tactus::workbench
