// The objective J against the iteration, for the participants on the page.
#pragma once

#include <QWidget>

#include "app/workbench/labs/speed/objective_trace.h"
#include "app/workbench/labs/speed/speed_result.h"

class QCustomPlot;

namespace tactus::workbench {

class ObjectivePlot : public QWidget {
  Q_OBJECT

 public:
  explicit ObjectivePlot(QWidget* parent = nullptr);

  /// `traces` belong to the participants from `first` on.
  void show(const SpeedResult& result, const std::vector<ObjectiveTrace>& traces, std::size_t first);

 private:
  QCustomPlot* plot_;
};

}  // namespace tactus::workbench
