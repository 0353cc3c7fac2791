// The averaged force along the depth with every expert, and below it who pulls where: each expert's distance from the
// mean, beside what a hand notices.
#pragma once

#include <QWidget>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/labs/experts/band_lab.h"
#include "app/workbench/plot/plot_menu.h"
#include "core/fuzzy/force_model.h"

class QCPAxisRect;
class QCPGraph;
class QCustomPlot;

namespace tactus::workbench {

class PullPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit PullPlot(QWidget* parent = nullptr);

  /// `x_input`: the input of the curves.
  void setCurves(const fuzzy::ForceModel& model, std::size_t x_input, const figures::ForceCurves& curves);
  /// The band around the mean, in place of that from the lowest to the highest expert; null: that one.
  void setBand(const ShownBand* band);
  void clear();

  QSize pictureSize() const override { return {1000, 760}; }
  std::vector<LegendEntry> legend() const override { return legend_; }
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 private:
  QCPGraph& addLine(QCPAxisRect& area, const QPen& pen);
  void drawBand(const figures::ForceCurves& curves);
  void drawForces(const fuzzy::ForceModel& model, const figures::ForceCurves& curves,
                  const std::vector<std::size_t>& numbers);
  void drawPulls(const fuzzy::ForceModel& model, const figures::ForceCurves& curves,
                 const std::vector<std::size_t>& numbers);

  QCustomPlot* plot_;
  QCPAxisRect* forces_;
  QCPAxisRect* pulls_;
  std::vector<LegendEntry> legend_;
  std::optional<ShownBand> band_;
};

}  // namespace tactus::workbench
