// What each expert says and would feel in the chosen cell, as an item model.
#pragma once

#include <QAbstractTableModel>

#include "app/workbench/labs/rules/rules_lab.h"

namespace tactus::workbench {

class CellTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kExpert, kWord, kFelt, kFromMean, kWithout, kSource, kColumns };

  /// `lab` outlives this.
  explicit CellTable(const RulesLab& lab, QObject* parent = nullptr);

  /// Shows the chosen cell of the lab.
  void follow();

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
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
