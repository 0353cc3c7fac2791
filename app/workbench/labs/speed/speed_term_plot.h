// The speed terms (paper, Fig. 8 and 3d): the ramps of each participant and the trapezoids averaged from them, with the
// 95 % intervals of their corners. The report draws the same.
#pragma once

#include <QWidget>
#include <string>

#include "app/workbench/labs/speed/speed_result.h"
#include "app/workbench/plot/plot_menu.h"

class QCustomPlot;
class QLabel;

namespace tactus::workbench {

class TermLabels;
class VertexPick;

class SpeedTermPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit SpeedTermPlot(QWidget* parent = nullptr);

  void show(const SpeedResult& result);
  VertexPick& corners() { return *corners_; }

  QSize pictureSize() const override { return {940, 340}; }
  std::vector<LegendEntry> legend() const override { return legend_; }
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 signals:
  /// The user clicked a corner of the averaged terms.
  void vertexAsked(const std::string& term, std::size_t point);

 private:
  void addLine(const std::vector<elicitation::Ramp>& ramps, double max_mm_s, const QPen& pen, const QString& name);
  void addIntervals(const SpeedResult& result);

  QCustomPlot* plot_;
  TermLabels* labels_;
  VertexPick* corners_;
  std::vector<LegendEntry> legend_;
};

}  // namespace tactus::workbench
