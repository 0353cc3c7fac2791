// Draws the cells of Table 2: votes as bars in the colors of the words, the winner's framed; the winner as its word.
#pragma once

#include <QStyledItemDelegate>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

class VoteTable;

class VoteDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  /// `votes` outlives this.
  explicit VoteDelegate(const VoteTable& votes, QObject* parent = nullptr);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  void paintVotes(QPainter& painter, const QRectF& place, const QModelIndex& index) const;

  const VoteTable& votes_;
};

}  // namespace tactus::workbench
