// The numbers of the speed lab: Table 1 with diagnostics, the warnings in words, the objective against the iteration.
#pragma once

#include <QWidget>
#include <memory>

#include "app/workbench/base/columns.h"
#include "app/workbench/labs/speed/speed_clusters.h"
#include "app/workbench/labs/speed/speed_lab.h"

class QCustomPlot;
class QLabel;
class QTableView;

namespace tactus::workbench {

/// The objective J against the iteration, for the participants on the page.
class ObjectivePlot : public QWidget {
  Q_OBJECT

 public:
  explicit ObjectivePlot(QWidget* parent = nullptr);

  /// `traces` belong to the participants from `first` on.
  void show(const SpeedResult& result, const std::vector<ObjectiveTrace>& traces, std::size_t first);

 private:
  QCustomPlot* plot_;
};

class NumberPage : public QWidget {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit NumberPage(SpeedLab& lab, QWidget* parent = nullptr);

 private:
  void refreshState();
  QString warningText() const;

  SpeedLab& lab_;
  Columns<std::shared_ptr<const SpeedSubject>>* table_;
  QTableView* view_;
  QLabel* warnings_;
  ObjectivePlot* objective_;
};

}  // namespace tactus::workbench
