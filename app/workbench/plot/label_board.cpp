#include "app/workbench/plot/label_board.h"

#include <QTransform>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tactus::workbench {
namespace {

constexpr double kTouch = 0.01;  // px that two boxes may share

QPointF directionOf(double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

// How far `box` reaches from its middle along the unit vector `axis`.
double reach(const TurnedBox& box, const QPointF& axis) {
  const QPointF along = directionOf(box.angle_deg);
  const QPointF across(-along.y(), along.x());
  return (std::abs(QPointF::dotProduct(along, axis)) * box.size.width() +
          std::abs(QPointF::dotProduct(across, axis)) * box.size.height()) /
         2;
}

}  // namespace

QPolygonF TurnedBox::corners() const {
  const QRectF flat(-size.width() / 2, -size.height() / 2, size.width(), size.height());
  return QTransform().translate(middle.x(), middle.y()).rotate(angle_deg).map(QPolygonF(flat).mid(0, 4));
}

TurnedBox boxOf(const QLineF& line, double width) {
  // QLineF counts angles against the clock.
  return {line.center(), {line.length(), width}, -line.angle()};
}

bool overlap(const TurnedBox& one, const TurnedBox& other) {
  // Two convex shapes are apart where a line between them is parallel to a side of one of them.
  for (const double angle : {one.angle_deg, one.angle_deg + 90, other.angle_deg, other.angle_deg + 90}) {
    const QPointF axis = directionOf(angle);
    const double apart = std::abs(QPointF::dotProduct(other.middle - one.middle, axis));
    if (apart > reach(one, axis) + reach(other, axis) - kTouch) return false;
  }
  return true;
}

bool LabelBoard::isFree(const TurnedBox& box) const {
  const QPointF reach_of{reach(box, {1, 0}), reach(box, {0, 1})};
  return bounds_.contains(box.middle - reach_of) && bounds_.contains(box.middle + reach_of) &&
         std::none_of(taken_.begin(), taken_.end(), [&box](const TurnedBox& other) { return overlap(box, other); });
}

bool LabelBoard::place(const TurnedBox& box) {
  if (!isFree(box)) return false;
  occupy(box);
  return true;
}

}  // namespace tactus::workbench
