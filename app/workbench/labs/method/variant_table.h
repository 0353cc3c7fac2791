// The values that were tried for one choice, as an item model.
#pragma once

#include <vector>

#include "app/workbench/labs/frame/lab_table_model.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/model/method_study.h"

namespace tactus::workbench {

class VariantTable : public LabTableModel {
  Q_OBJECT

 public:
  enum Column { kValue, kRms, kNoticeable, kFelt, kLargest, kWhere };

  explicit VariantTable(QObject* parent = nullptr);
  /// The variants of `factor`; an empty one shows none.
  void setFactor(const elicitation::MethodStudy& study, const std::string& factor, const fuzzy::ForceModel& model);
  void clear();
  /// The index in the study of the variant in `row`.
  std::size_t variantAt(int row) const { return rows_[static_cast<std::size_t>(row)].index; }
  /// The row of a variant, -1 if it is none of them.
  int rowOf(std::size_t variant) const;

 private:
  int rows() const override;
  QVariant cell(int row, int column, int role) const override;

  struct Row {
    std::size_t index;
    elicitation::MethodVariant variant;
    QString where;
  };
  std::vector<Row> rows_;
};

}  // namespace tactus::workbench
