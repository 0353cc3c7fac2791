// Table 1 of the paper, live, with what the clusters say of each participant: a row for each participant and a column
// for each level's mean and SD, then the agreement of clusters and levels.
#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/labs/speed/speed_result.h"

namespace tactus::workbench {

class SpeedTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  void show(std::shared_ptr<const SpeedResult> result);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// Columns after the levels.
  enum Measure { kAccuracy, kRand, kSeparation, kTrend, kSilhouette, kXieBeni, kWarnings, kMeasures };
  std::size_t levels() const;
  QString measureText(const SpeedSubject& subject, int measure) const;

  std::shared_ptr<const SpeedResult> result_;
};

}  // namespace tactus::workbench
