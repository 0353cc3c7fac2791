#include "app/workbench/tune/terms/grip_finder.h"

#include <algorithm>
#include <cmath>

#include "core/fuzzy/membership.h"

namespace tactus::workbench {
namespace {

using Part = Grip::Part;

double distance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

double distanceToLine(QPointF place, QPointF from, QPointF to) {
  const QPointF along = to - from;
  const double length_squared = QPointF::dotProduct(along, along);
  if (length_squared == 0) return distance(place, from);
  const double share = std::clamp(QPointF::dotProduct(place - from, along) / length_squared, 0.0, 1.0);
  return distance(place, from + share * along);
}

struct Found {
  Grip grip;
  double distance_px = 0;
  bool preferred = false;
};

/// Keeps the best of what is within reach.
class Best {
 public:
  explicit Best(double reach) : reach_(reach) {}

  /// `later_wins`: of two at the same distance.
  void offer(const Found& found, bool later_wins) {
    constexpr double kSame = 0.5;  // px
    if (found.distance_px > reach_) return;
    if (any_) {
      const double more = found.distance_px - best_.distance_px;
      if (more > kSame) return;
      if (more > -kSame) {
        if (best_.preferred && !found.preferred) return;
        if (best_.preferred == found.preferred && !later_wins) return;
      }
    }
    best_ = found;
    any_ = true;
  }

  std::optional<Grip> grip() const { return any_ ? std::optional<Grip>(best_.grip) : std::nullopt; }

 private:
  double reach_;
  bool any_ = false;
  Found best_;
};

std::optional<Grip> vertexAt(const PlotFrame& frame, const std::vector<fuzzy::Term>& terms, QPointF place,
                             std::optional<std::size_t> preferred) {
  Best best(kVertexReach);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    for (const GripHandle& handle : handlesOf(terms, t)) {
      const QPointF at = frame.pixelOf(handle.x, handle.membership);
      // Handles come from left to right: the last of some at one place is the one that is free to the right.
      best.offer({handle.grip, distance(place, at), preferred == t}, place.x() > at.x());
    }
  }
  return best.grip();
}

std::optional<Grip> edgeAt(const PlotFrame& frame, const std::vector<fuzzy::Term>& terms, QPointF place,
                           std::optional<std::size_t> preferred) {
  Best best(kEdgeReach);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const auto& p = terms[t].points;
    if (terms[t].shape == fuzzy::Shape::kGaussian) continue;
    const std::size_t count = p.size();
    const double left = distanceToLine(place, frame.pixelOf(p[0], 0), frame.pixelOf(p[1], 1));
    const double right = distanceToLine(place, frame.pixelOf(p[count - 2], 1), frame.pixelOf(p[count - 1], 0));
    best.offer({{t, Part::kLeftEdge, 0, false}, left, preferred == t}, false);
    best.offer({{t, Part::kRightEdge, 0, false}, right, preferred == t}, true);
  }
  return best.grip();
}

std::optional<Grip> termAt(const PlotFrame& frame, const std::vector<fuzzy::Term>& terms, QPointF place,
                           std::optional<std::size_t> preferred) {
  if (!frame.area.contains(place)) return std::nullopt;
  const double x = frame.valueAt(place.x());
  const double height = (frame.area.bottom() - place.y()) / frame.area.height() * frame.top;
  std::optional<Grip> found;
  double highest = 0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const double membership = fuzzy::MembershipFunction::of(terms[t])(x);
    if (membership <= 0 || membership < height) continue;
    if (preferred == t) return Grip{t, Part::kTerm, 0, false};
    if (membership <= highest) continue;
    highest = membership;
    found = Grip{t, Part::kTerm, 0, false};
  }
  return found;
}

}  // namespace

QPointF PlotFrame::pixelOf(double x, double membership) const {
  return {area.left() + (x - low) / (high - low) * area.width(), area.bottom() - membership / top * area.height()};
}

double PlotFrame::valueAt(double x_px) const { return low + (x_px - area.left()) / area.width() * (high - low); }

std::optional<Grip> gripAt(const PlotFrame& frame, const std::vector<fuzzy::Term>& terms, QPointF place,
                           std::optional<std::size_t> preferred) {
  if (auto vertex = vertexAt(frame, terms, place, preferred)) return vertex;
  if (auto edge = edgeAt(frame, terms, place, preferred)) return edge;
  return termAt(frame, terms, place, preferred);
}

}  // namespace tactus::workbench
