// The records behind a number as an item model.
#pragma once

#include <memory>

#include "app/workbench/labs/frame/lab_table_model.h"
#include "app/workbench/labs/origins/origin_finder.h"

namespace tactus::workbench {

class OriginTable : public LabTableModel {
  Q_OBJECT

 public:
  enum Column { kParticipant, kRecord, kSays, kMoves };
  static constexpr int kOrderRole = Qt::UserRole;  ///< what a column is sorted by

  /// `finder` outlives this.
  explicit OriginTable(const OriginFinder& finder, QObject* parent = nullptr);

 private:
  int rows() const override;
  QVariant cell(int row, int column, int role) const override;
  QString movesText(std::size_t row) const;

  const OriginFinder& finder_;
  std::shared_ptr<const Origin> origin_;  ///< what the rows show: the finder may have the next one already
};

}  // namespace tactus::workbench
