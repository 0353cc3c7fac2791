// The numbers of the speed lab: Table 1 with diagnostics, the warnings in words, the objective against the iteration.
#pragma once

#include <QWidget>

class QLabel;
class QTableView;

namespace tactus::workbench {

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
