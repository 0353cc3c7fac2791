// The numbers of the speed lab: Table 1 with diagnostics, the warnings in words, the objective against the iteration.
#pragma once

#include <QWidget>
#include <memory>

#include "app/workbench/base/columns.h"
#include "app/workbench/labs/speed/speed_clusters.h"
#include "app/workbench/labs/speed/speed_lab.h"

class QLabel;
class QTableView;

namespace tactus::workbench {

class ChartView;

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
  ChartView* objective_;
};

}  // namespace tactus::workbench
