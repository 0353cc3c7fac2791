// The averaged force over the depth as it is and with another choice of the method, with what a hand does not notice.
#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/labs/method/method_lab.h"
#include "app/workbench/plot/plot_menu.h"

class QCustomPlot;

namespace tactus::workbench {

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

}  // namespace tactus::workbench
