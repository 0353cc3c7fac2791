// The method study on the screen: one button, the choices with a sentence each, and the two curves of the chosen one.
#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/labs/method/method_lab.h"
#include "app/workbench/plot/plot_menu.h"

class QCustomPlot;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;

namespace tactus::workbench {

/// The averaged force over the depth as it is and with another choice of the method, with what a hand does not notice.
class MethodPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit MethodPlot(QWidget* parent = nullptr);

  /// `other`: the name of the other curve. `marked`: the place of the largest difference has a line.
  void setCurves(const fuzzy::ForceModel& model, const MethodCurves& curves, const QString& other, bool marked);
  void clear();

  QSize pictureSize() const override { return {1000, 560}; }
  std::vector<LegendEntry> legend() const override { return legend_; }
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 private:
  /// Without curves there are no axes.
  void showAxes(bool shown);
  void addLine(const std::vector<double>& x, const std::vector<fuzzy::Evaluation>& forces, const QString& name,
               const QPen& pen);

  QCustomPlot* plot_;
  std::vector<LegendEntry> legend_;
};

class LabCard;
class MethodLab;
class MethodPlot;

class MethodLabView : public LabView {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit MethodLabView(MethodLab& lab, QWidget* parent = nullptr);

  QPushButton& button() { return *button_; }
  QTableView& factorView() { return *factor_view_; }
  MethodPlot& plot() { return *plot_; }

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
  MethodPlot* plot_;
  QPushButton* button_;
  QProgressBar* progress_;
  QLabel* state_;
  QLabel* place_;
  int shown_ = -1;  ///< which finding is in the tables
};

}  // namespace tactus::workbench
