// The force of the last ten seconds: what the hand feels, or split into fuzzy force, friction and limits; in a
// replay the recorded force beside it.
#pragma once

#include <QWidget>

#include "app/workbench/plots/plot_source.h"

class QCustomPlot;
class QCPGraph;

namespace tactus::workbench {

class FeelHistory;

class ForceTracePlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit ForceTracePlot(QWidget* parent = nullptr);

  /// End of the force axis, > 0; a larger force makes it longer.
  void setFullScale(double full_n);
  /// Shows what makes up the force as well.
  void setSplit(bool split);
  bool isSplit() const { return split_; }
  /// Draws the last ten seconds; the newest point is at the right.
  void setHistory(const FeelHistory& history);

  QSize pictureSize() const override { return {1000, 360}; }
  std::vector<LegendEntry> legend() const override;
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void nameAxes(bool roomy);

  QCustomPlot* plot_;
  QCPGraph* force_;
  QCPGraph* recorded_;  ///< of the recording that is replayed
  QCPGraph* friction_;
  QCPGraph* model_;
  QCPGraph* limits_;  ///< fills what the limits took, between friction and force
  bool split_ = false;
  double full_n_ = 1;
};

}  // namespace tactus::workbench
