#include "app/editing/membership_edits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/edit.h"
#include "app/editing/term_edits.h"
#include "app/editing/term_list.h"
#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::editing {
namespace {

// Moves vertices of one term list together, as far as they can go. Internal to membership_edits.

/// A vertex by the index of its term in the list and its index in Term::points.
struct Vertex {
  std::size_t term = 0;
  std::size_t point = 0;

  bool operator==(const Vertex&) const = default;
};

/// Vertices of one list that move by the same distance. In a partition, vertices of neighboring terms at the same place
/// move together.
class VertexMove {
 public:
  /// `list` must not move. `order`: of a partition; null if the terms need not sum to one.
  VertexMove(const OpenList& list, bool is_output, const TermOrder* order);

  /// Adds the vertex and all vertices at the same place.
  void add(const Vertex& vertex);
  const std::vector<Vertex>& vertices() const { return moving_; }

  /// Moves all vertices by `by`, or until one of them is stopped; that one ends exactly at its stop.
  void run(double by);
  /// Moves vertices that are all at one place exactly to `to`, or until they are stopped.
  void runTo(double to);

  /// Why the vertices stopped short; empty if they did not.
  const std::string& stopped() const { return stopped_; }

 private:
  struct Bounds {
    double low;
    double high;
    std::string why_low;
    std::string why_high;

    void raise(double value, const std::string& why);
    void lower(double value, const std::string& why);
  };

  bool isMoving(const Vertex& vertex) const;
  const fuzzy::Term& termOf(const Vertex& vertex) const { return (*list_.terms)[vertex.term]; }
  double& at(const Vertex& vertex) { return (*list_.terms)[vertex.term].points[vertex.point]; }
  std::vector<Vertex> liesOn(const Vertex& vertex) const;
  /// The range of the vertex. It always contains the current place.
  Bounds boundsOf(const Vertex& vertex) const;
  void bound(const Vertex& vertex, Bounds& bounds) const;
  void boundByNeighbors(const Vertex& vertex, Bounds& bounds) const;
  void boundByPartition(const Vertex& vertex, Bounds& bounds) const;
  void boundByOutput(const Vertex& vertex, Bounds& bounds) const;
  bool inOrder() const;

  OpenList list_;
  bool is_output_;
  const TermOrder* order_;
  double range_;
  double narrowest_;
  std::vector<Vertex> moving_;
  std::string stopped_;
};

using fuzzy::Shape;
using fuzzy::Term;

constexpr double kSmallestSigmaShare = 1e-4;
constexpr double kLargestSigmaShare = 10;

std::size_t lastPoint(const Term& term) { return term.points.size() - 1; }

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

using base::ErrorCode;
using base::fail;
using base::Result;
using fuzzy::ForceModel;
using fuzzy::Shape;
using fuzzy::Term;

Result<void> checkFinite(double value, const std::string& place) {
  if (std::isfinite(value)) return {};
  return fail(ErrorCode::kValue, place, base::formatNumber(value), "a finite number");
}

/// One move in the making: a copy of the model with the term that is moved in it.
struct Moving {
  ForceModel model;
  OpenList list;
  std::size_t term = 0;
  std::optional<TermOrder> order;

  const Term& moved() const { return (*list.terms)[term]; }
  std::string name() const { return list.title() + " / " + labelOf(moved()); }
  VertexMove begin() const { return {list, list.variable == &model.output, order ? &*order : nullptr}; }
};

/// Fills `moving`, which must stay where it is: its list points into its model.
Result<void> open(Moving& moving, const ForceModel& model, const TermPlace& place, bool sum_to_one) {
  moving.model = model;
  TACTUS_TRY(auto list, openList(moving.model, place.list));
  moving.list = list;
  TACTUS_TRY(const auto term, findTermIn(moving.list, place.term));
  moving.term = term;
  if (!sum_to_one) return {};
  moving.order = partitionOrder(*moving.list.variable, *moving.list.terms);
  if (moving.order) return {};
  return fail(ErrorCode::kValue, moving.list.title(), "terms that do not sum to one",
              "terms that do, or to edit without that mode");
}

Result<void> checkLocks(const Moving& moving, const std::vector<Vertex>& vertices, const TermListId& list,
                        const std::vector<VertexPlace>& locked) {
  for (const Vertex& vertex : vertices) {
    const Term& term = (*moving.list.terms)[vertex.term];
    if (std::find(locked.begin(), locked.end(), VertexPlace{list, term.id, vertex.point}) == locked.end()) continue;
    return fail(ErrorCode::kValue, moving.list.title() + " / " + labelOf(term),
                "the " + pointName(term.shape, vertex.point) + " locked", "a vertex that is not locked");
  }
  return {};
}

Result<Edit> moveBy(Moving& moving, const std::vector<Vertex>& vertices, double by, const std::string& what,
                    const TermListId& list, const MoveOptions& options) {
  if (auto ok = checkFinite(by, moving.name()); !ok) return tl::unexpected(ok.error());
  VertexMove move = moving.begin();
  for (const Vertex& vertex : vertices) move.add(vertex);
  if (move.vertices().empty()) {
    return fail(ErrorCode::kValue, moving.name(), "the only term", "two terms or more where terms sum to one");
  }
  if (auto ok = checkLocks(moving, move.vertices(), list, options.locked); !ok) return tl::unexpected(ok.error());
  const Vertex first = vertices.front();
  const double before = moving.moved().points[first.point];
  move.run(by);
  const double way = moving.moved().points[first.point] - before;
  std::string label =
      moving.name() + ": " + what + (way < 0 ? " by " : " by +") + quantityText(*moving.list.variable, way);
  return finished(std::move(moving.model), std::move(label), move.stopped());
}

}  // namespace

Result<Edit> moveVertex(const ForceModel& model, const VertexPlace& place, double to, const MoveOptions& options) {
  Moving moving;
  if (auto ok = open(moving, model, {place.list, place.term}, options.sum_to_one); !ok) {
    return tl::unexpected(ok.error());
  }
  if (auto ok = checkFinite(to, moving.name()); !ok) return tl::unexpected(ok.error());
  const Term& term = moving.moved();
  if (place.point >= term.points.size()) {
    return fail(ErrorCode::kReference, moving.name(), "vertex " + std::to_string(place.point),
                "one of the " + std::to_string(term.points.size()) + " of a " + std::string(name(term.shape)));
  }
  VertexMove move = moving.begin();
  move.add({moving.term, place.point});
  if (auto ok = checkLocks(moving, move.vertices(), place.list, options.locked); !ok) {
    return tl::unexpected(ok.error());
  }
  const auto& variable = *moving.list.variable;
  const double before = term.points[place.point];
  move.runTo(to);
  std::string label = moving.name() + ": " + pointName(term.shape, place.point) + ' ' + numberText(variable, before) +
                      " to " + quantityText(variable, term.points[place.point]);
  return finished(std::move(moving.model), std::move(label), move.stopped());
}

Result<Edit> moveEdge(const ForceModel& model, const TermPlace& place, Side side, double by,
                      const MoveOptions& options) {
  Moving moving;
  if (auto ok = open(moving, model, place, options.sum_to_one); !ok) return tl::unexpected(ok.error());
  const Term& term = moving.moved();
  if (term.shape == Shape::kGaussian) {
    return fail(ErrorCode::kValue, moving.name(), "a Gaussian, which has no edges", "a trapezoid or a triangle");
  }
  const std::size_t first = side == Side::kLeft ? 0 : term.points.size() - 2;
  return moveBy(moving, {{moving.term, first}, {moving.term, first + 1}}, by,
                side == Side::kLeft ? "left edge" : "right edge", place.list, options);
}

Result<Edit> moveTerm(const ForceModel& model, const TermPlace& place, double by, const MoveOptions& options) {
  Moving moving;
  if (auto ok = open(moving, model, place, options.sum_to_one); !ok) return tl::unexpected(ok.error());
  const Term& term = moving.moved();
  std::size_t first = 0;
  std::size_t end = term.shape == Shape::kGaussian ? 1 : term.points.size();
  if (moving.order) {
    if (moving.term == moving.order->front()) first = 2;
    if (moving.term == moving.order->back()) end -= 2;
  }
  std::vector<Vertex> vertices;
  for (std::size_t p = first; p < end; ++p) vertices.push_back({moving.term, p});
  return moveBy(moving, vertices, by, "moved", place.list, options);
}

Result<Edit> setPoints(const ForceModel& model, const TermPlace& place, std::span<const double> points) {
  Moving moving;
  if (auto ok = open(moving, model, place, false); !ok) return tl::unexpected(ok.error());
  const auto& variable = *moving.list.variable;
  std::vector<std::string> texts;
  for (const double point : points) texts.push_back(numberText(variable, point));
  std::string label = moving.name() + ": points " + base::joined(texts, ", ");
  (*moving.list.terms)[moving.term].points.assign(points.begin(), points.end());
  return finished(std::move(moving.model), std::move(label));
}

}  // namespace tactus::editing
