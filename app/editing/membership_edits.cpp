#include "app/editing/membership_edits.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "app/editing/edit_text.h"
#include "app/editing/vertex_move.h"
#include "core/base/text.h"

namespace tactus::editing {
namespace {

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
  auto list = openList(moving.model, place.list);
  if (!list) return tl::unexpected(list.error());
  moving.list = *list;
  const auto term = findTermIn(moving.list, place.term);
  if (!term) return tl::unexpected(term.error());
  moving.term = *term;
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
