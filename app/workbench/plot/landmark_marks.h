// Landmarks of the anatomy at an edge of a plot with a depth axis: a bar or a tick, and a name. Only files of
// plots/ include this.
#pragma once

#include <vector>

#include "app/workbench/plot/landmarks.h"
#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {

class LandmarkMarks : public QCPLayerable {
  Q_OBJECT

 public:
  enum class Place {
    kInside,  ///< at the lower edge, over the ground of the plot
    kAbove,   ///< on top of the plot, which leaves height() for them
    kUnder,   ///< under the upper edge, where the ground of the plot is free
    kBeside,  ///< along the left axis, over the ground of the plot, where that axis is the depth
  };

  LandmarkMarks(QCustomPlot& plot, Place place);

  /// The landmarks of the axis of `variable`, none where it is not the depth.
  void setVariable(const fuzzy::Variable& variable);
  /// Without names where there is no room for them: bars alone.
  void setNamed(bool named) { named_ = named; }
  /// One line per landmark with its place and its source; empty where there are none.
  QString explanation() const;
  /// Room that the bars and the rows of names take, px; 0 without landmarks.
  int height() const;

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  void drawBeside(QCPPainter& painter) const;

  Place place_;
  bool named_ = true;
  std::vector<Landmark> landmarks_;
  QFont font_;
};

}  // namespace tactus::workbench
