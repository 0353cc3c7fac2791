// The experts with their weights and what leaving each one out would change, as an item model. The weights can be
// edited.
#pragma once

#include <QAbstractTableModel>

#include "app/workbench/labs/experts/experts_lab.h"

namespace tactus::workbench {

class WeightTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kExpert, kWeight, kRms, kLargest, kNoticeable, kWhere, kColumns };

  /// `lab` outlives this.
  explicit WeightTable(ExpertsLab& lab, QObject* parent = nullptr);

  /// Shows what the lab has.
  void follow();

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString shown(std::size_t expert, int column) const;

  ExpertsLab& lab_;
  std::shared_ptr<const elicitation::BuiltModel> built_;
  std::vector<std::size_t> numbers_;  ///< of the experts, for their colors
};

}  // namespace tactus::workbench
