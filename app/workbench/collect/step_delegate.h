// Draws the cells of the participants' table: a mark and a word for each step, so that no state is told by color alone.
#pragma once

#include <QStyledItemDelegate>

namespace tactus::workbench {

class StepDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace tactus::workbench
