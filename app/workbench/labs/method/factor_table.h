// The choices of the method study as an item model, the largest effect first, each with one sentence: does it matter?
#pragma once

#include "app/workbench/labs/frame/lab_table_model.h"
#include "elicitation/model/method_study.h"

namespace tactus::workbench {

class FactorTable : public LabTableModel {
  Q_OBJECT

 public:
  enum Column { kFactor, kNow, kSentence, kLargest, kNoticeable };

  explicit FactorTable(QObject* parent = nullptr);
  /// Null: no study.
  void setStudy(const elicitation::MethodStudy* study);
  /// The index in the study of the choice in `row`.
  std::size_t factorAt(int row) const { return order_[static_cast<std::size_t>(row)]; }

 private:
  int rows() const override;
  QVariant cell(int row, int column, int role) const override;

  elicitation::MethodStudy study_;
  std::vector<std::size_t> order_;
};

/// `23.1 %`; a share above 0 is never shown as 0.
QString feltText(double share);

}  // namespace tactus::workbench
