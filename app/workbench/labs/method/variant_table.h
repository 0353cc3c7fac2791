// The values that were tried for one choice, as an item model.
#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "elicitation/model/method_study.h"

namespace tactus::workbench {

class VariantTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kValue, kRms, kNoticeable, kFelt, kLargest, kWhere, kColumns };

  using QAbstractTableModel::QAbstractTableModel;
  /// The variants of `factor`; an empty one shows none.
  void setFactor(const elicitation::MethodStudy& study, const std::string& factor, const fuzzy::ForceModel& model);
  void clear();
  /// The index in the study of the variant in `row`.
  std::size_t variantAt(int row) const { return rows_[static_cast<std::size_t>(row)].index; }
  /// The row of a variant, -1 if it is none of them.
  int rowOf(std::size_t variant) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    std::size_t index;
    elicitation::MethodVariant variant;
    QString where;
  };
  std::vector<Row> rows_;
};

}  // namespace tactus::workbench
