// Table 2 of the open study, live: votes, winners and reasons.
#pragma once

#include <QStyledItemDelegate>
#include <QWidget>
#include <string>

#include "app/workbench/labs/force/force_lab.h"
#include "core/fuzzy/force_model.h"

class QLabel;
class QTableView;

namespace tactus::workbench {

class ElidedLabel;
class VoteTable;

// Draws the cells of Table 2: votes as bars in the colors of the words, the winner's framed; the winner as its word.

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

class VotesView : public QWidget {
  Q_OBJECT

 public:
  explicit VotesView(QWidget* parent = nullptr);

  void setVotes(const ForceVotes& votes);
  const VoteTable& table() const { return *table_; }

 signals:
  /// A row was chosen.
  void forceChosen(double force_n);
  /// The user asks who cast the votes for `word` at a force; for all words if it is empty.
  void originAsked(double force_n, const std::string& word);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fitReasons();
  void openMenu(const QPoint& place);

  VoteTable* table_;
  QTableView* view_;
  ElidedLabel* summary_;
  QLabel* refusal_;
};

}  // namespace tactus::workbench
