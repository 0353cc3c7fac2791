#include "core/analysis/term_conversion.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/fuzzy/membership.h"

namespace tactus::analysis {

std::optional<std::size_t> strongestTerm(const fuzzy::Variable& variable, double x) {
  std::optional<std::size_t> best;
  double largest = 0;
  for (std::size_t t = 0; t < variable.terms.size(); ++t) {
    const double membership = fuzzy::MembershipFunction::of(variable.terms[t])(x);
    if (membership <= largest) continue;
    largest = membership;
    best = t;
  }
  return best;
}

namespace {

using fuzzy::MembershipFunction;

// Edges that were averaged over experts may differ by rounding.
constexpr double kSameEdge = 1e-9;

}  // namespace

TermOrder byMiddleOfCore(const std::vector<fuzzy::Term>& terms) {
  TermOrder order(terms.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto middle = [&](std::size_t t) {
    const auto f = MembershipFunction::of(terms[t]);
    return f.gaussian ? f.mean : f.b / 2 + f.c / 2;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) { return middle(x) < middle(y); });
  return order;
}

std::optional<TermOrder> partitionOrder(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms) {
  for (const fuzzy::Term& term : terms) {
    if (term.shape == fuzzy::Shape::kGaussian) return std::nullopt;
  }
  TermOrder order = byMiddleOfCore(terms);
  const double same = kSameEdge * (variable.max - variable.min);
  const auto first = MembershipFunction::of(terms[order.front()]);
  const auto last = MembershipFunction::of(terms[order.back()]);
  if (first.b > variable.min || last.c < variable.max) return std::nullopt;
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    const auto left = MembershipFunction::of(terms[order[k]]);
    const auto right = MembershipFunction::of(terms[order[k + 1]]);
    if (std::abs(left.c - right.a) > same || std::abs(left.d - right.b) > same) return std::nullopt;
  }
  return order;
}

namespace {

using fuzzy::Shape;
using fuzzy::Term;

/// sqrt(2 ln 2): where a Gaussian of sigma 1 is 1/2.
constexpr double kHalfOfGaussian = 1.1774100225154747;

/// What the three shapes have in common.
struct Outline {
  double peak;
  double left;             ///< 1/2 here
  double right;            ///< and here
  bool from_left = true;   ///< the left side slopes; otherwise it is a vertical edge at the peak
  bool from_right = true;  ///< the same of the right side
};

Outline outlineOf(const Term& term, double min, double max) {
  const auto& p = term.points;
  if (term.shape == Shape::kGaussian) {
    const double half = kHalfOfGaussian * p[1];
    Outline out{p[0], p[0] - half, p[0] + half};
    out.from_left = p[0] > min;
    out.from_right = p[0] < max;
    return out;
  }
  const double b = p[1];
  const double c = p[p.size() - 2];
  Outline out{b + (c - b) / 2, p[0] + (b - p[0]) / 2, c + (p.back() - c) / 2};
  const bool at_start = b <= min && c >= min && out.right > min;
  const bool at_end = b <= max && c >= max && out.left < max;
  if (at_start && !at_end) {
    out.from_left = false;
    out.peak = min;
  }
  if (at_end && !at_start) {
    out.from_right = false;
    out.peak = max;
  }
  return out;
}

std::vector<double> trapezoid(const Outline& o) {
  // Core and ramps of equal width, as near to a Gaussian as a trapezoid with a core of half the width at 1/2 gets.
  const double left = o.from_left ? (o.peak - o.left) / 2 : 0;
  const double right = o.from_right ? (o.right - o.peak) / 2 : 0;
  return {o.peak - 3 * left, o.peak - left, o.peak + right, o.peak + 3 * right};
}

std::vector<double> triangle(const Outline& o) {
  return {o.from_left ? std::min(2 * o.left - o.peak, o.peak) : o.peak, o.peak,
          o.from_right ? std::max(2 * o.right - o.peak, o.peak) : o.peak};
}

std::vector<double> gaussian(const Outline& o) {
  if (o.from_left && o.from_right) return {o.left + (o.right - o.left) / 2, (o.right - o.left) / 2 / kHalfOfGaussian};
  return {o.peak, (o.from_right ? o.right - o.peak : o.peak - o.left) / kHalfOfGaussian};
}

}  // namespace

base::Result<Term> convertedTerm(const Term& term, Shape shape, double min, double max) {
  if (term.shape == shape) return term;
  Term out = term;
  out.shape = shape;
  if (term.shape == Shape::kTriangle && shape == Shape::kTrapezoid) {
    out.points.insert(out.points.begin() + 1, term.points[1]);
    return out;
  }
  const Outline outline = outlineOf(term, min, max);
  switch (shape) {
    case Shape::kTrapezoid: out.points = trapezoid(outline); break;
    case Shape::kTriangle: out.points = triangle(outline); break;
    case Shape::kGaussian:
      out.points = gaussian(outline);
      if (!(out.points[1] > 0)) {
        return base::fail(base::ErrorCode::kValue, term.label.empty() ? term.id : term.label, "a term without width",
                          "one of some width, from which a sigma follows");
      }
      break;
  }
  return out;
}

}  // namespace tactus::analysis
