// Table 1 of the paper, live, with what the clusters say of each participant: a row for each participant and a column
// for each level's mean and SD, then the agreement of clusters and levels.
#pragma once

#include <memory>

#include "app/workbench/labs/frame/lab_table_model.h"
#include "app/workbench/labs/speed/speed_result.h"

namespace tactus::workbench {

class SpeedTable : public LabTableModel {
  Q_OBJECT

 public:
  using LabTableModel::LabTableModel;

  void show(std::shared_ptr<const SpeedResult> result);

 private:
  /// Columns after the levels.
  enum Measure { kAccuracy, kRand, kSeparation, kTrend, kSilhouette, kXieBeni, kWarnings };
  int rows() const override { return result_ ? static_cast<int>(result_->subjects.size()) : 0; }
  QVariant cell(int row, int column, int role) const override;
  std::size_t levels() const;
  QString measureText(const SpeedSubject& subject, int measure) const;

  std::shared_ptr<const SpeedResult> result_;
};

}  // namespace tactus::workbench
