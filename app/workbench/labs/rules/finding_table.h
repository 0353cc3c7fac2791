// The findings about the experts' rules as an item model: grouped by kind, the group with the most newtons first.
#pragma once

#include <vector>

#include "app/workbench/labs/frame/lab_table_model.h"
#include "app/workbench/labs/rules/worded_finding.h"

namespace tactus::workbench {

class FindingTable : public LabTableModel {
  Q_OBJECT

 public:
  enum Column { kKind, kNewtons, kExperts, kSentence };

  explicit FindingTable(QObject* parent = nullptr);

  /// `unit`: of the force.
  void setFindings(const std::vector<WordedFinding>& findings, const std::string& unit);
  /// The finding of a row, as an index of what was set.
  std::size_t findingAt(int row) const { return rows_[static_cast<std::size_t>(row)].finding; }

 private:
  int rows() const override;
  QVariant cell(int row, int column, int role) const override;

  struct Row {
    std::size_t finding = 0;
    std::size_t group = 0;  ///< findings of the group, in its first row; else 0
  };

  std::vector<WordedFinding> findings_;
  std::string unit_;
  std::vector<Row> rows_;
};

}  // namespace tactus::workbench
