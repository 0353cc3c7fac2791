// The records behind a number as an item model.
#pragma once

#include <QAbstractTableModel>

#include "app/workbench/labs/origins/origin_finder.h"

namespace tactus::workbench {

class OriginTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kParticipant, kRecord, kSays, kMoves, kColumns };
  static constexpr int kOrderRole = Qt::UserRole;  ///< what a column is sorted by

  /// `finder` outlives this.
  explicit OriginTable(const OriginFinder& finder, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString movesText(std::size_t row) const;

  const OriginFinder& finder_;
};

}  // namespace tactus::workbench
