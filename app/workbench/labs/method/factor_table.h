// The choices of the method study as an item model, the largest effect first, each with one sentence: does it matter?
#pragma once

#include <QAbstractTableModel>
#include <optional>

#include "elicitation/model/method_study.h"

namespace tactus::workbench {

class FactorTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kFactor, kNow, kSentence, kNoticeable, kColumns };

  using QAbstractTableModel::QAbstractTableModel;
  /// Null: no study.
  void setStudy(const elicitation::MethodStudy* study);
  /// The index in the study of the choice in `row`.
  std::size_t factorAt(int row) const { return order_[static_cast<std::size_t>(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  elicitation::MethodStudy study_;
  std::vector<std::size_t> order_;
};

/// `23.1 %`; a share above 0 is never shown as 0.
QString feltText(double share);

}  // namespace tactus::workbench
