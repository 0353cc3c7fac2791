#include "app/editing/partition.h"

#include <algorithm>
#include <utility>

#include "app/editing/edit_text.h"
#include "core/fuzzy/membership.h"

namespace tactus::editing {
namespace {

using base::ErrorCode;
using base::fail;
using fuzzy::MembershipFunction;
using fuzzy::Shape;
using fuzzy::Term;

bool anyGaussian(const std::vector<Term>& terms) {
  return std::any_of(terms.begin(), terms.end(), [](const Term& term) { return term.shape == Shape::kGaussian; });
}

/// A ramp shared by two neighbors.
struct Ramp {
  double from;
  double to;
};

/// Ramps one after the other, none narrower than `narrowest`.
void putInOrder(std::vector<Ramp>& ramps, double narrowest) {
  std::vector<double> knots;
  for (const Ramp& ramp : ramps) knots.insert(knots.end(), {ramp.from, ramp.to});
  std::sort(knots.begin(), knots.end());
  for (std::size_t r = 0; r < ramps.size(); ++r) {
    const double from = r == 0 ? knots[0] : std::max(knots[2 * r], ramps[r - 1].to);
    ramps[r] = {from, std::max(knots[2 * r + 1], from + narrowest)};
  }
}

}  // namespace

base::Result<Edit> makeSumToOne(const fuzzy::ForceModel& model, const TermListId& list) {
  fuzzy::ForceModel out = model;
  const auto open = openList(out, list);
  if (!open) return tl::unexpected(open.error());
  auto& terms = *open->terms;
  const fuzzy::Variable& variable = *open->variable;
  if (anyGaussian(terms)) {
    return fail(ErrorCode::kValue, open->title(), "a Gaussian", "trapezoids and triangles, which can sum to one");
  }
  const TermOrder order = analysis::byMiddleOfCore(terms);
  std::vector<Ramp> ramps;
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    const auto left = MembershipFunction::of(terms[order[k]]);
    const auto right = MembershipFunction::of(terms[order[k + 1]]);
    const auto inside = [&](double x) { return std::clamp(x, variable.min, variable.max); };
    ramps.push_back({inside(left.c / 2 + right.a / 2), inside(left.d / 2 + right.b / 2)});
  }
  putInOrder(ramps, kNarrowestShare * (variable.max - variable.min));
  for (std::size_t k = 0; k < order.size(); ++k) {
    Term& term = terms[order[k]];
    const Ramp left = k == 0 ? Ramp{variable.min, variable.min} : ramps[k - 1];
    const double end = k == 0 ? variable.max : std::max(variable.max, left.to);
    const Ramp right = k + 1 == order.size() ? Ramp{end, end} : ramps[k];
    const bool stays_triangle = term.shape == Shape::kTriangle && left.to == right.from;
    term.shape = stays_triangle ? Shape::kTriangle : Shape::kTrapezoid;
    term.points = stays_triangle ? std::vector{left.from, left.to, right.to}
                                 : std::vector{left.from, left.to, right.from, right.to};
  }
  return finished(std::move(out), open->title() + ": terms sum to one");
}

}  // namespace tactus::editing
