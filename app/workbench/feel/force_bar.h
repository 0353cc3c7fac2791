// The force on the hand as a bar on the scale of the trace, with the force cap of the servo.
#pragma once

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "app/workbench/plot/plot_menu.h"
#include "core/fuzzy/force_model.h"

class QCPGraph;
class QCustomPlot;

namespace tactus::workbench {

// The force of the last ten seconds: the force on the hand, or its parts (fuzzy force, friction, limits). A replay also
// shows the recorded force. The wheel and Shift-drag choose the part of the time that is shown.

class AxisZoom;
class FeelHistory;
class ShownRanges;

class ForceTracePlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit ForceTracePlot(QWidget* parent = nullptr);

  /// Names the force axis after `output`. The axis ends at the upper end of the universe (> 0), or at a larger force.
  void setOutput(const fuzzy::Variable& output);
  /// Whether to show the parts of the force, too.
  void setSplit(bool split);
  bool isSplit() const { return split_; }
  /// The upper end of the force axis, N.
  double topN() const;
  /// Draws the last ten seconds; the newest point is at the right.
  void setHistory(const FeelHistory& history);

  QSize pictureSize() const override { return {1000, 360}; }
  /// Empty if the felt force is the only line.
  std::vector<LegendEntry> legend() const override;
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void nameAxes(bool roomy);
  fuzzy::Variable forceAxis() const;

  QCustomPlot* plot_;
  ShownRanges* ranges_;  ///< of the time, which no other plot has
  AxisZoom* zoom_;
  QCPGraph* force_;
  QCPGraph* recorded_;  ///< force of the replayed recording
  QCPGraph* friction_;
  QCPGraph* model_;
  QCPGraph* limits_;  ///< fills the area that the limits removed, between friction and force
  bool split_ = false;
  bool replays_ = false;  ///< a replay, with the recorded force beside it
  double full_n_ = 1;
  std::string force_name_;
};

class ForceBar : public QWidget {
  Q_OBJECT

 public:
  explicit ForceBar(QWidget* parent = nullptr);

  /// `force_n` fills the bar. A mark shows `friction_n`, the requested force, if the limits reduced it.
  void setForces(double force_n, double friction_n);
  /// Sets the end of the scale, > 0, and the largest force that the servo gives. A cap behind the end is only named.
  void setScale(double full_n, double cap_n);
  /// A higher bar, to be read from afar.
  void setLarge(bool large);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {100, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintScale(QPainter& painter, const QRectF& scale, const std::function<double(double)>& x_of) const;

  double force_n_ = 0;
  double friction_n_ = 0;
  double full_n_ = 2;
  double cap_n_ = 2;
  int bar_height_;  ///< px
};

}  // namespace tactus::workbench
