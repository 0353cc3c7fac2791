// The raw trace of one stroke among those of its level, for looking at: nothing can be corrected here.
#pragma once

#include <QWidget>
#include <optional>

#include "app/workbench/labs/speed/stroke_traces.h"
#include "elicitation/tracing/sources.h"

namespace tactus::workbench {

class TraceRow;

class StrokePreview : public QWidget {
  Q_OBJECT

 public:
  /// `lab_data` outlives this.
  explicit StrokePreview(LabData& lab_data, QWidget* parent = nullptr);

  void showStroke(const elicitation::StrokeKey& stroke);
  const TraceRow& row() const { return *row_; }

 private:
  void follow();

  StrokeTraces traces_;
  std::optional<elicitation::StrokeKey> stroke_;
  TraceRow* row_;
};

}  // namespace tactus::workbench
