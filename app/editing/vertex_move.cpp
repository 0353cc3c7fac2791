#include "app/editing/vertex_move.h"

#include <algorithm>
#include <limits>

#include "app/editing/edit_text.h"
#include "core/base/check.h"

namespace tactus::editing {
namespace {

using fuzzy::Shape;
using fuzzy::Term;

constexpr double kSmallestSigmaShare = 1e-4;
constexpr double kLargestSigmaShare = 10;

std::size_t lastPoint(const Term& term) { return term.points.size() - 1; }

}  // namespace

void VertexMove::Bounds::raise(double value, const std::string& why) {
  if (value <= low) return;
  low = value;
  why_low = why;
}

void VertexMove::Bounds::lower(double value, const std::string& why) {
  if (value >= high) return;
  high = value;
  why_high = why;
}

VertexMove::VertexMove(const OpenList& list, bool is_output, const TermOrder* order)
    : list_(list),
      is_output_(is_output),
      order_(order),
      range_(list.variable->max - list.variable->min),
      narrowest_(kNarrowestShare * range_) {
  if (order_ == nullptr) return;
  // What lies on each other within rounding now does so exactly.
  for (std::size_t k = 0; k + 1 < order_->size(); ++k) {
    const auto& left = (*list_.terms)[(*order_)[k]].points;
    auto& right = (*list_.terms)[(*order_)[k + 1]].points;
    right[0] = left[left.size() - 2];
    right[1] = left.back();
  }
}

bool VertexMove::isMoving(const Vertex& vertex) const {
  return std::find(moving_.begin(), moving_.end(), vertex) != moving_.end();
}

std::vector<Vertex> VertexMove::liesOn(const Vertex& vertex) const {
  if (order_ == nullptr) return {};
  const auto place = static_cast<std::size_t>(std::find(order_->begin(), order_->end(), vertex.term) - order_->begin());
  std::vector<Vertex> out;
  if (vertex.point <= 1 && place > 0) {
    const std::size_t left = (*order_)[place - 1];
    out.push_back({left, lastPoint((*list_.terms)[left]) - 1 + vertex.point});
  }
  const std::size_t shoulder = lastPoint(termOf(vertex)) - 1;
  if (vertex.point >= shoulder && place + 1 < order_->size()) {
    out.push_back({(*order_)[place + 1], vertex.point - shoulder});
  }
  return out;
}

void VertexMove::add(const Vertex& vertex) {
  if (isMoving(vertex)) return;
  moving_.push_back(vertex);
  for (const Vertex& other : liesOn(vertex)) add(other);
}

void VertexMove::boundByNeighbors(const Vertex& vertex, Bounds& bounds) const {
  const Term& term = termOf(vertex);
  const std::size_t last = lastPoint(term);
  const auto gap = [&](std::size_t left) {
    return order_ != nullptr && (left == 0 || left + 1 == last) ? narrowest_ : 0.0;
  };
  const auto name = [&](std::size_t point) { return "the " + pointName(term.shape, point) + " of " + labelOf(term); };
  const std::size_t p = vertex.point;
  if (p > 0 && !isMoving({vertex.term, p - 1})) bounds.raise(term.points[p - 1] + gap(p - 1), name(p - 1));
  if (p < last && !isMoving({vertex.term, p + 1})) bounds.lower(term.points[p + 1] - gap(p), name(p + 1));
}

void VertexMove::boundByPartition(const Vertex& vertex, Bounds& bounds) const {
  if (order_ == nullptr) return;
  const std::string why = "the end of the universe, where the terms must sum to one";
  if (vertex.term == order_->front() && vertex.point == 1) bounds.lower(list_.variable->min, why);
  if (vertex.term == order_->back() && vertex.point + 1 == lastPoint(termOf(vertex))) {
    bounds.raise(list_.variable->max, why);
  }
}

void VertexMove::boundByOutput(const Vertex& vertex, Bounds& bounds) const {
  if (!is_output_) return;
  const Term& term = termOf(vertex);
  const std::size_t last = lastPoint(term);
  const std::string why = "the width in its universe that an output term needs";
  if (vertex.point == 0) {
    bounds.lower(list_.variable->max - narrowest_, why);
    if (!isMoving({vertex.term, last})) bounds.lower(term.points[last] - narrowest_, why);
  }
  if (vertex.point == last) {
    bounds.raise(list_.variable->min + narrowest_, why);
    if (!isMoving({vertex.term, 0})) bounds.raise(term.points[0] + narrowest_, why);
  }
}

void VertexMove::bound(const Vertex& vertex, Bounds& bounds) const {
  const auto& variable = *list_.variable;
  if (termOf(vertex).shape == Shape::kGaussian) {
    if (vertex.point == 1) {
      bounds.raise(kSmallestSigmaShare * range_, "the smallest sigma");
      bounds.lower(kLargestSigmaShare * range_, "the largest sigma");
      return;
    }
    if (is_output_) {
      bounds.raise(variable.min, "the start of the universe");
      bounds.lower(variable.max, "the end of the universe");
      return;
    }
  } else {
    boundByNeighbors(vertex, bounds);
    boundByPartition(vertex, bounds);
    boundByOutput(vertex, bounds);
  }
  bounds.raise(variable.min - range_, "one universe before its start");
  bounds.lower(variable.max + range_, "one universe behind its end");
}

VertexMove::Bounds VertexMove::boundsOf(const Vertex& vertex) const {
  constexpr double kFar = std::numeric_limits<double>::max();
  Bounds bounds{-kFar, kFar, {}, {}};
  const double here = termOf(vertex).points[vertex.point];
  // What lies on the vertex binds it too, and so it stays there.
  for (const Vertex& other : moving_) {
    if (other == vertex || (order_ != nullptr && termOf(other).points[other.point] == here)) bound(other, bounds);
  }
  bounds.low = std::min(bounds.low, here);
  bounds.high = std::max(bounds.high, here);
  return bounds;
}

bool VertexMove::inOrder() const {
  return std::all_of(moving_.begin(), moving_.end(), [&](const Vertex& vertex) {
    const auto& points = termOf(vertex).points;
    return termOf(vertex).shape == Shape::kGaussian || std::is_sorted(points.begin(), points.end());
  });
}

void VertexMove::run(double by) {
  const auto before = *list_.terms;
  std::vector<Bounds> bounds;
  for (const Vertex& vertex : moving_) bounds.push_back(boundsOf(vertex));
  double way = by;
  std::size_t stop = moving_.size();
  for (std::size_t m = 0; m < moving_.size(); ++m) {
    const double end = by < 0 ? bounds[m].low : bounds[m].high;
    const double room = end - at(moving_[m]);
    if (by < 0 ? room <= way : room >= way) continue;
    way = room;
    stop = m;
  }
  if (stop < moving_.size()) stopped_ = by < 0 ? bounds[stop].why_low : bounds[stop].why_high;
  const auto place = [&](double share, bool exactly) {
    *list_.terms = before;
    for (std::size_t m = 0; m < moving_.size(); ++m) {
      double& value = at(moving_[m]);
      const double start = value;
      value = std::clamp(start + share * way, bounds[m].low, bounds[m].high);
      if (!exactly || stop == moving_.size()) continue;
      const Vertex& first = moving_[stop];
      if (start == before[first.term].points[first.point]) value = by < 0 ? bounds[stop].low : bounds[stop].high;
    }
    return inOrder();
  };
  // Rounding may put two vertices that almost lie on each other out of order: then a little less far, or not at all.
  constexpr double kAlmost = 1 - 1e-12;
  if (!place(1, true) && !place(1, false) && !place(kAlmost, false)) *list_.terms = before;
}

void VertexMove::runTo(double to) {
  TACTUS_CHECK(!moving_.empty());
  const Bounds bounds = boundsOf(moving_.front());
  const double end = std::clamp(to, bounds.low, bounds.high) + 0.0;  // no negative zero
  if (to < bounds.low) stopped_ = bounds.why_low;
  if (to > bounds.high) stopped_ = bounds.why_high;
  const auto before = *list_.terms;
  for (const Vertex& vertex : moving_) at(vertex) = end;
  if (!inOrder()) *list_.terms = before;
}

}  // namespace tactus::editing
