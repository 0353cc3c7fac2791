// The force of the last ten seconds: what the hand feels, or split into fuzzy force, friction and limits; in a
// replay the recorded force beside it.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "app/workbench/plot/plot_source.h"
#include "core/fuzzy/force_model.h"

class QCustomPlot;
class QCPGraph;

namespace tactus::workbench {

class FeelHistory;

class ForceTracePlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit ForceTracePlot(QWidget* parent = nullptr);

  /// The force axis has the name of `output` and ends at its end, > 0; a larger force makes it longer.
  void setOutput(const fuzzy::Variable& output);
  /// Shows what makes up the force as well.
  void setSplit(bool split);
  bool isSplit() const { return split_; }
  /// Draws the last ten seconds; the newest point is at the right.
  void setHistory(const FeelHistory& history);

  QSize pictureSize() const override { return {1000, 360}; }
  /// None where the force that is felt is the only line.
  std::vector<LegendEntry> legend() const override;
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void nameAxes(bool roomy);
  fuzzy::Variable forceAxis() const;

  QCustomPlot* plot_;
  QCPGraph* force_;
  QCPGraph* recorded_;  ///< of the recording that is replayed
  QCPGraph* friction_;
  QCPGraph* model_;
  QCPGraph* limits_;  ///< fills what the limits took, between friction and force
  bool split_ = false;
  bool replays_ = false;  ///< beside what was recorded
  double full_n_ = 1;
  std::string force_name_;
};

}  // namespace tactus::workbench
