// The distance between each two experts as an item model: root mean square in N where both have a rule.
#pragma once

#include <QAbstractTableModel>

#include "app/workbench/labs/experts/experts_lab.h"

namespace tactus::workbench {

class PairTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit PairTable(const ExpertsLab& lab, QObject* parent = nullptr);
  void follow();

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override { return rowCount(parent); }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// Of two different experts.
  const elicitation::ExpertDistance& between(int first, int second) const;

  const ExpertsLab& lab_;
  std::shared_ptr<const elicitation::BuiltModel> built_;
};

}  // namespace tactus::workbench
