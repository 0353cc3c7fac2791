// The method study on the screen: one button, the choices with a sentence each, and the two curves of the chosen one.
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;

namespace tactus::workbench {

class FactorTable;
class LabCard;
class MethodLab;
class MethodPlot;
class VariantTable;

class MethodLabView : public QWidget {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit MethodLabView(MethodLab& lab, QWidget* parent = nullptr);

  QPushButton& button() { return *button_; }
  QTableView& factorView() { return *factor_view_; }
  MethodPlot& plot() { return *plot_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeHead();
  QWidget* makeLeft();
  QWidget* makeRight();
  void follow();
  void followFactor();
  void followCurves();

  MethodLab& lab_;
  FactorTable* factors_;
  VariantTable* variants_;
  QTableView* factor_view_ = nullptr;
  QTableView* variant_view_ = nullptr;
  MethodPlot* plot_;
  QPushButton* button_;
  QProgressBar* progress_;
  QLabel* state_;
  QLabel* place_;
  int shown_ = -1;  ///< which finding is in the tables
};

}  // namespace tactus::workbench
