// The experts with their weights and what leaving each one out would change, as an item model. The weights can be
// edited.
#pragma once

#include "app/workbench/labs/experts/experts_lab.h"
#include "app/workbench/labs/frame/lab_table_model.h"

namespace tactus::workbench {

class WeightTable : public LabTableModel {
  Q_OBJECT

 public:
  enum Column { kExpert, kWeight, kRms, kLargest, kNoticeable, kWhere };

  /// `lab` outlives this.
  explicit WeightTable(ExpertsLab& lab, QObject* parent = nullptr);

  /// Shows what the lab has.
  void follow();

  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 private:
  int rows() const override;
  QVariant cell(int row, int column, int role) const override;
  QString shown(std::size_t expert, int column) const;

  ExpertsLab& lab_;
  std::shared_ptr<const elicitation::BuiltModel> built_;
  std::vector<std::size_t> numbers_;  ///< of the experts, for their colors
};

}  // namespace tactus::workbench
