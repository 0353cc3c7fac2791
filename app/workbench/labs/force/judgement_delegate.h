// Draws the cells of the judgements: each judgement is its word in its color; a corrected one has a corner.
#pragma once

#include <QStyledItemDelegate>

namespace tactus::workbench {

class JudgementGrid;

class JudgementDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  /// `grid` outlives this.
  explicit JudgementDelegate(const JudgementGrid& grid, QObject* parent = nullptr);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  const JudgementGrid& grid_;
};

}  // namespace tactus::workbench
