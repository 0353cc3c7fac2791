// The numbers of the speed lab: Table 1 with diagnostics, the warnings in words, the objective against the iteration.
#pragma once

#include <QWidget>
#include <memory>

#include "app/workbench/labs/frame/lab_table_model.h"
#include "app/workbench/labs/speed/speed_lab.h"
#include "app/workbench/labs/speed/speed_result.h"

class QCustomPlot;
class QLabel;
class QTableView;

namespace tactus::workbench {

/// Table 1 of the paper, live, with what the clusters say of each participant: a row for each participant and a column
/// for each level's mean and SD, then the agreement of clusters and levels.
class SpeedTable : public LabTableModel {
  Q_OBJECT

 public:
  using LabTableModel::LabTableModel;

  void show(std::shared_ptr<const SpeedResult> result);

 private:
  /// Columns after the levels.
  enum Measure { kAccuracy, kRand, kSeparation, kTrend, kSilhouette, kXieBeni, kWarnings };
  int rows() const override { return result_ ? static_cast<int>(result_->subjects.size()) : 0; }
  QVariant cell(int row, int column, int role) const override;
  std::size_t levels() const;
  QString measureText(const SpeedSubject& subject, int measure) const;

  std::shared_ptr<const SpeedResult> result_;
};

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

class ObjectivePlot;
class SpeedLab;
class SpeedTable;

class NumberPage : public QWidget {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit NumberPage(SpeedLab& lab, QWidget* parent = nullptr);

 private:
  void follow();
  QString warningText() const;

  SpeedLab& lab_;
  SpeedTable* table_;
  QTableView* view_;
  QLabel* warnings_;
  ObjectivePlot* objective_;
};

}  // namespace tactus::workbench
