// Texts and lines on a drawing, so that no two texts overlap and no line runs through a text: boxes that may be turned.
#pragma once

#include <QLineF>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QSizeF>
#include <vector>

namespace tactus::workbench {

/// A rectangle around a middle, turned by an angle.
struct TurnedBox {
  QPointF middle;
  QSizeF size;
  double angle_deg = 0;  ///< clockwise on the screen, as QPainter turns

  QPolygonF corners() const;
};

/// The box around a line, `width` px wide.
TurnedBox boxOf(const QLineF& line, double width);

/// Whether two boxes have more than an edge in common.
bool overlap(const TurnedBox& one, const TurnedBox& other);

class LabelBoard {
 public:
  /// Only what lies in `bounds` as a whole is placed.
  explicit LabelBoard(const QRectF& bounds) : bounds_(bounds) {}

  bool isFree(const TurnedBox& box) const;
  /// Keeps the room of `box` whether it is free or not.
  void take(const TurnedBox& box) { taken_.push_back(box); }
  /// Takes the room of `box` if it is free.
  bool place(const TurnedBox& box);

 private:
  QRectF bounds_;
  std::vector<TurnedBox> taken_;
};

}  // namespace tactus::workbench
