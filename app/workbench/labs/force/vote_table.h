// Table 2 of the study as an item model: a row for each force, with the votes for each word, the winner and the reason.
#pragma once

#include <string>

#include "app/workbench/labs/force/force_data.h"
#include "app/workbench/labs/frame/lab_table_model.h"

namespace tactus::workbench {

class VoteTable : public LabTableModel {
  Q_OBJECT

 public:
  static constexpr int kForce = 0;
  static constexpr int kFirstWord = 1;
  static constexpr int kShareRole = Qt::UserRole;     ///< double: share of the votes at this force
  static constexpr int kWinsRole = Qt::UserRole + 1;  ///< bool: the word of this column won

  using LabTableModel::LabTableModel;

  void setVotes(const ForceVotes& votes);
  int words() const { return static_cast<int>(words_.terms.size()); }
  int winnerColumn() const { return kFirstWord + words(); }
  /// The id of the word of a column; empty for the other columns.
  std::string wordAt(int column) const;
  int reasonColumn() const { return winnerColumn() + 1; }
  const elicitation::VoteStep& step(int row) const { return steps_[static_cast<std::size_t>(row)]; }

 private:
  int rows() const override { return static_cast<int>(steps_.size()); }
  QVariant cell(int row, int column, int role) const override;
  QString shown(const elicitation::VoteStep& step, int column) const;

  fuzzy::Variable words_;
  std::vector<elicitation::VoteStep> steps_;
};

}  // namespace tactus::workbench
