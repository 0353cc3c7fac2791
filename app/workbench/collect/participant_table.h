// The participants of the study as a table: one row each, one column for each step.
#pragma once

#include <QAbstractTableModel>
#include <optional>

#include "app/workbench/collect/collect_controller.h"

namespace tactus::workbench {

class ParticipantTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  static constexpr int kCode = 0;
  static constexpr int kFirstStep = 1;
  static constexpr int kNext = kFirstStep + static_cast<int>(kCollectSteps);
  static constexpr int kLastSeen = kNext + 1;
  static constexpr int kLanguage = kLastSeen + 1;
  static constexpr int kColumns = kLanguage + 1;

  explicit ParticipantTable(CollectController& collect, QObject* parent = nullptr);

  /// The step that `column` shows, or nothing.
  static std::optional<CollectStep> stepOf(int column);
  const ParticipantRow& participant(int row) const;
  /// The row of `person`, or -1.
  int rowOf(const study::RecordId& person) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void follow();
  QString shown(const ParticipantRow& row, int column) const;

  CollectController& collect_;
  std::vector<ParticipantRow> rows_;
};

}  // namespace tactus::workbench
