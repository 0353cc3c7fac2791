// The findings about the experts' rules as an item model: grouped by kind, the group with the most newtons first.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "elicitation/rules/rule_finding.h"

namespace tactus::workbench {

class FindingTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kKind, kNewtons, kExperts, kSentence, kColumns };

  using QAbstractTableModel::QAbstractTableModel;

  /// `unit`: of the force.
  void setFindings(const std::vector<elicitation::RuleFinding>& findings, const std::string& unit);
  /// The finding of a row, as an index of what was set.
  std::size_t findingAt(int row) const { return rows_[static_cast<std::size_t>(row)].finding; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    std::size_t finding = 0;
    std::size_t group = 0;  ///< findings of the group, in its first row; else 0
  };

  std::vector<elicitation::RuleFinding> findings_;
  std::string unit_;
  std::vector<Row> rows_;
};

}  // namespace tactus::workbench
