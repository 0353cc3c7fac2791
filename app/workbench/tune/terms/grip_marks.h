// The handles of the membership function editor: dots to take hold of, what is held drawn strong, and a tag that names
// it. Only files of plots/ include this.
#pragma once

#include <optional>
#include <vector>

#include "app/workbench/plot/plot_style.h"
#include "app/workbench/tune/terms/term_grip.h"

namespace tactus::workbench {

class GripMarks : public QCPLayerable {
  Q_OBJECT

 public:
  struct Handle {
    double x = 0;
    double membership = 0;
    QColor color;
    bool large = false;  ///< of the term that is selected
    bool locked = false;
    bool moves = false;  ///< with what is held or under the mouse
  };
  /// A line on the shape that moves, between two places.
  struct Stroke {
    double from_x = 0, from_membership = 0;
    double to_x = 0, to_membership = 0;
  };

  /// `layer` has a buffer of its own, so the handles follow the mouse without drawing the shapes again.
  GripMarks(QCustomPlot& plot, const QString& layer);

  void setHandles(std::vector<Handle> handles);
  void setStrokes(std::vector<Stroke> strokes);
  /// `text` beside the place (x, membership); empty: no tag. `warns`: the tag says why something cannot move.
  void setTag(const QString& text, double x, double membership, bool warns);
  /// The part of the x axis that is the universe; what lies beyond is shaded.
  void setUniverse(double min, double max);

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  QPointF pixelOf(double x, double membership) const;
  void drawHandle(QCPPainter& painter, const Handle& handle) const;
  void drawTag(QCPPainter& painter) const;

  std::vector<Handle> handles_;
  std::vector<Stroke> strokes_;
  QString tag_;
  double tag_x_ = 0;
  double tag_membership_ = 0;
  bool tag_warns_ = false;
  double min_ = 0;
  double max_ = 1;
  QFont font_;
};

}  // namespace tactus::workbench
