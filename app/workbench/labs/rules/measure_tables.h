// The measures of agreement and the answers to the usability scale (Table 3) as item models.
#pragma once

#include "app/workbench/labs/frame/lab_table_model.h"
#include "app/workbench/labs/rules/agreement_rows.h"

namespace tactus::workbench {

class AgreementTable : public LabTableModel {
  Q_OBJECT

 public:
  enum Column { kRatings, kSize, kOrdinal, kInterval, kConsensus, kIntervalAlpha, kNominal, kKendall, kFleiss };

  explicit AgreementTable(QObject* parent = nullptr);
  void setRows(std::vector<AgreementRow> rows);

 private:
  int rows() const override;
  QVariant cell(int row, int column, int role) const override;

  std::vector<AgreementRow> rows_;
};

class UsabilityTable : public LabTableModel {
  Q_OBJECT

 public:
  enum Column { kStatement, kCount, kHere, kHereRange, kPublished, kPublishedRange };

  explicit UsabilityTable(QObject* parent = nullptr);
  void setRows(std::vector<UsabilityRow> rows);

 private:
  int rows() const override;
  QVariant cell(int row, int column, int role) const override;

  std::vector<UsabilityRow> rows_;
};

}  // namespace tactus::workbench
