// Marks the places where no rule fires: hatched over the whole height where every expert abstains, and a hatched lane
// at the lower edge for each expert who abstains alone. Needs QCustomPlot: only plotting code includes this.
#pragma once

#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {

class SilenceMarks : public QCPLayerable {
  Q_OBJECT

 public:
  struct Lane {
    QString text;
    QColor color;
    std::vector<figures::Interval> intervals;
  };

  explicit SilenceMarks(QCustomPlot& plot);

  /// `everyone`: the intervals in which all experts abstain; `lanes`: those of single experts. Draws at most six lanes;
  /// the last one then stands for all other experts.
  void set(std::vector<figures::Interval> everyone, std::vector<Lane> lanes);

  /// Height at the lower edge that is used for something else, px.
  void setFoot(double px) { foot_ = px; }

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  std::vector<figures::Interval> inSight(const std::vector<figures::Interval>& intervals) const;
  void drawEveryone(QCPPainter& painter, const figures::Interval& interval) const;
  void drawLane(QCPPainter& painter, const Lane& lane, double bottom) const;

  QFont font_;
  double foot_ = 0;
  std::vector<figures::Interval> everyone_;
  std::vector<Lane> lanes_;
};

}  // namespace tactus::workbench
