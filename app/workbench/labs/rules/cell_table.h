// What each expert says and would feel in the chosen cell, as an item model.
#pragma once

#include "app/workbench/labs/frame/lab_table_model.h"
#include "app/workbench/labs/rules/rules_lab.h"

namespace tactus::workbench {

class CellTable : public LabTableModel {
  Q_OBJECT

 public:
  enum Column { kExpert, kWord, kFelt, kFromMean, kWithout, kSource };
  static constexpr int kOrderRole = Qt::UserRole;  ///< what a column is sorted by

  /// `lab` outlives this.
  explicit CellTable(const RulesLab& lab, QObject* parent = nullptr);

  /// Shows the chosen cell of the lab.
  void follow();
  /// Shows what the rules of the chosen cell move.
  void followInfluences();

 private:
  int rows() const override;
  QVariant cell(int row, int column, int role) const override;
  QVariant orderOf(std::size_t row, int column) const;
  QString withoutText(std::size_t row) const;

  struct Row {
    QString expert;
    std::size_t number = 0;
    QString word;
    std::optional<std::size_t> term;
    std::optional<double> felt_n;
    QString source;
  };

  const RulesLab& lab_;
  std::vector<Row> rows_;
  std::optional<double> mean_n_;  ///< of the felt forces
};

/// What the differences in the chosen cell cost, in two or three sentences; empty if no cell is chosen.
QString cellSummary(const RulesLab& lab);

}  // namespace tactus::workbench
