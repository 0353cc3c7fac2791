#include "core/analysis/partition.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/fuzzy/membership.h"

namespace tactus::analysis {
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

}  // namespace tactus::analysis
