#include "app/workbench/model/patient.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/fuzzy/membership.h"

namespace tactus::workbench {

double coreMiddle(const fuzzy::Variable& variable, const fuzzy::Term& term) {
  const auto inside = [&variable](double x) { return std::clamp(x, variable.min, variable.max); };
  switch (term.shape) {
    case fuzzy::Shape::kTrapezoid: return (inside(term.points[1]) + inside(term.points[2])) / 2;
    case fuzzy::Shape::kTriangle: return inside(term.points[1]);
    case fuzzy::Shape::kGaussian: return inside(term.points[0]);
  }
  return variable.min;
}

figures::Interval halfRange(const fuzzy::Variable& variable, const fuzzy::Term& term) {
  const std::vector<double>& p = term.points;
  figures::Interval half;
  if (term.shape == fuzzy::Shape::kGaussian) {
    const double away = p[1] * std::sqrt(2 * std::numbers::ln2);
    half = {p[0] - away, p[0] + away};
  } else {
    half = {std::midpoint(p[0], p[1]), std::midpoint(p[p.size() - 2], p[p.size() - 1])};
  }
  return {std::clamp(half.low, variable.min, variable.max), std::clamp(half.high, variable.min, variable.max)};
}

std::optional<std::size_t> strongestTerm(const fuzzy::Variable& variable, double value) {
  std::optional<std::size_t> best;
  double largest = 0;
  for (std::size_t i = 0; i < variable.terms.size(); ++i) {
    const double membership = fuzzy::MembershipFunction::of(variable.terms[i])(value);
    if (membership <= largest) continue;
    largest = membership;
    best = i;
  }
  return best;
}

EndPoses endPoses(const fuzzy::Variable& pose) {
  return {coreMiddle(pose, pose.terms.front()), coreMiddle(pose, pose.terms.back())};
}

}  // namespace tactus::workbench
