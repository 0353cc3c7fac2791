// The method study on the screen: one button, the choices with a sentence each, and the two curves of the chosen one.
#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/labs/method/method_lab.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;

namespace tactus::workbench {

class ChartView;
class LabCard;
class MethodLab;

class MethodLabView : public LabView {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit MethodLabView(MethodLab& lab, QWidget* parent = nullptr);

  QPushButton& button() { return *button_; }
  QTableView& factorView() { return *factor_view_; }
  ChartView& plot() { return *plot_; }

 private:
  QWidget* makeHead();
  QWidget* makeLeft();
  QWidget* makeRight();
  void refreshState();
  void followFactor();
  void followCurves();

  MethodLab& lab_;
  Columns<FactorRow>* factors_;
  Columns<VariantRow>* variants_;
  QTableView* factor_view_ = nullptr;
  QTableView* variant_view_ = nullptr;
  ChartView* plot_;
  QPushButton* button_;
  QProgressBar* progress_;
  QLabel* state_;
  QLabel* place_;
  int shown_ = -1;  ///< which finding is in the tables
};

}  // namespace tactus::workbench
