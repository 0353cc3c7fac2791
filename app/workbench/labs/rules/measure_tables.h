// The measures of agreement and the answers to the usability scale (Table 3) as item models.
#pragma once

#include <QAbstractTableModel>

#include "app/workbench/labs/rules/agreement_rows.h"

namespace tactus::workbench {

class AgreementTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    kRatings,
    kSize,
    kOrdinal,
    kInterval,
    kConsensus,
    kIntervalAlpha,
    kNominal,
    kKendall,
    kFleiss,
    kColumns
  };

  using QAbstractTableModel::QAbstractTableModel;
  void setRows(std::vector<AgreementRow> rows);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<AgreementRow> rows_;
};

class UsabilityTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kStatement, kCount, kHere, kHereRange, kPublished, kPublishedRange, kColumns };

  using QAbstractTableModel::QAbstractTableModel;
  void setRows(std::vector<UsabilityRow> rows);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<UsabilityRow> rows_;
};

}  // namespace tactus::workbench
