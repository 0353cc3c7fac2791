// The weight policies beside equal weights, in newtons, as an item model.
#pragma once

#include <QAbstractTableModel>

#include "app/workbench/labs/experts/experts_lab.h"

namespace tactus::workbench {

class PolicyTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kPolicy, kWeights, kLargest, kRms, kWhere, kColumns };

  explicit PolicyTable(const ExpertsLab& lab, QObject* parent = nullptr);
  void follow();

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  const ExpertsLab& lab_;
  std::vector<ComparedWeights> rows_;
};

/// `Equal`, `By years of experience`, …
QString policyName(elicitation::WeightPolicy policy);

}  // namespace tactus::workbench
