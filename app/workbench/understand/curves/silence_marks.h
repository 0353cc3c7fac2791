// Where no rule fires: hatched over the whole height where every expert abstains, and a hatched lane at the foot of the
// plot for each expert who abstains alone. Only files of plots/ include this.
#pragma once

#include <vector>

#include "app/workbench/model/force_curves.h"
#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {

class SilenceMarks : public QCPLayerable {
  Q_OBJECT

 public:
  struct Lane {
    QString text;
    QColor color;
    std::vector<Interval> intervals;
  };

  explicit SilenceMarks(QCustomPlot& plot);

  /// `everyone`: where all experts abstain; `lanes`: where single experts do. At most six lanes are drawn, the last one
  /// then stands for all the others.
  void set(std::vector<Interval> everyone, std::vector<Lane> lanes);

  /// Room at the foot of the plot, px, that something else takes.
  void setFoot(double px) { foot_ = px; }

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  void drawEveryone(QCPPainter& painter, const Interval& interval) const;
  void drawLane(QCPPainter& painter, const Lane& lane, double bottom) const;

  QFont font_;
  double foot_ = 0;
  std::vector<Interval> everyone_;
  std::vector<Lane> lanes_;
};

}  // namespace tactus::workbench
