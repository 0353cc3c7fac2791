// Places texts and lines on a drawing so that no two texts overlap and no line crosses a text. Boxes may be turned.
#pragma once

#include <QLineF>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QSizeF>
#include <vector>

namespace tactus::workbench {

/// A rectangle around a center, turned by an angle.
struct TurnedBox {
  QPointF middle;
  QSizeF size;
  double angle_deg = 0;  ///< clockwise on the screen, as in QPainter

  QPolygonF corners() const;
};

/// The box around a line, `width` px wide.
TurnedBox boxOf(const QLineF& line, double width);

/// Whether two boxes share more than an edge.
bool overlap(const TurnedBox& one, const TurnedBox& other);

class LabelBoard {
 public:
  /// Boxes are placed only if they lie completely inside `bounds`.
  explicit LabelBoard(const QRectF& bounds) : bounds_(bounds) {}

  bool isFree(const TurnedBox& box) const;
  /// Reserves `box`, free or not.
  void occupy(const TurnedBox& box) { taken_.push_back(box); }
  /// Reserves `box` if it is free. Returns whether it was.
  bool place(const TurnedBox& box);

 private:
  QRectF bounds_;
  std::vector<TurnedBox> taken_;
};

}  // namespace tactus::workbench
