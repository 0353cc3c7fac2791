// The weight policies beside equal weights, in newtons, as an item model.
#pragma once

#include "app/workbench/labs/experts/experts_lab.h"
#include "app/workbench/labs/frame/lab_table_model.h"

namespace tactus::workbench {

class PolicyTable : public LabTableModel {
  Q_OBJECT

 public:
  enum Column { kPolicy, kWeights, kLargest, kRms, kWhere };

  explicit PolicyTable(const ExpertsLab& lab, QObject* parent = nullptr);
  void follow();

 private:
  int rows() const override;
  QVariant cell(int row, int column, int role) const override;

  const ExpertsLab& lab_;
  std::vector<ComparedWeights> rows_;
};

/// `Equal`, `By years of experience`, …
QString policyName(elicitation::WeightPolicy policy);

}  // namespace tactus::workbench
