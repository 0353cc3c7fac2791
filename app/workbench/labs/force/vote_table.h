// Table 2 of the study as an item model: a row for each force, with the votes for each word, the winner and the reason.
#pragma once

#include <QAbstractTableModel>
#include <string>

#include "app/workbench/labs/force/force_data.h"

namespace tactus::workbench {

class VoteTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  static constexpr int kForce = 0;
  static constexpr int kFirstWord = 1;
  static constexpr int kShareRole = Qt::UserRole;     ///< double: share of the votes at this force
  static constexpr int kWinsRole = Qt::UserRole + 1;  ///< bool: the word of this column won

  using QAbstractTableModel::QAbstractTableModel;

  void setVotes(const ForceVotes& votes);
  int words() const { return static_cast<int>(words_.terms.size()); }
  int winnerColumn() const { return kFirstWord + words(); }
  /// The id of the word of a column; empty for the other columns.
  std::string wordAt(int column) const;
  int reasonColumn() const { return winnerColumn() + 1; }
  const elicitation::VoteStep& step(int row) const { return steps_[static_cast<std::size_t>(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString shown(const elicitation::VoteStep& step, int column) const;

  fuzzy::Variable words_;
  std::vector<elicitation::VoteStep> steps_;
};

}  // namespace tactus::workbench
