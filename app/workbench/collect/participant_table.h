// The participants of the study as a table: one row each, one column for each step.
#pragma once

#include <optional>

#include "app/workbench/base/columns.h"
#include "app/workbench/collect/collect_controller.h"

namespace tactus::workbench {

class ParticipantTable : public Columns<ParticipantRow> {
 public:
  static constexpr int kCode = 0;
  static constexpr int kFirstStep = 1;
  static constexpr int kNext = kFirstStep + static_cast<int>(kCollectSteps);
  static constexpr int kLastSeen = kNext + 1;

  explicit ParticipantTable(CollectController& collect, QObject* parent = nullptr);

  /// The step that `column` shows, or nothing.
  static std::optional<CollectStep> stepOf(int column);
  /// The row of `person`, or -1.
  int rowOf(const study::RecordId& person) const;
};

}  // namespace tactus::workbench
