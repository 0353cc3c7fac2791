#include "core/fuzzy/membership.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tactus::fuzzy {
namespace {

/// numerator / denominator for positive arguments, never rounded down to 0.
double share(double numerator, double denominator) noexcept {
  return std::max(numerator / denominator, std::numeric_limits<double>::denorm_min());
}

}  // namespace

MembershipFunction MembershipFunction::of(const Term& term) noexcept {
  MembershipFunction f;
  const auto& p = term.points;
  switch (term.shape) {
    case Shape::kTrapezoid: f.a = p[0], f.b = p[1], f.c = p[2], f.d = p[3]; break;
    case Shape::kTriangle: f.a = p[0], f.b = f.c = p[1], f.d = p[2]; break;
    case Shape::kGaussian:
      f.gaussian = true;
      f.mean = p[0], f.sigma = p[1];
      break;
  }
  return f;
}

double MembershipFunction::scaled(double x, double scale) const noexcept {
  if (gaussian) {
    const double u = (x - mean) / sigma;
    return scale * std::exp(-0.5 * u * u);
  }
  if (x < b) return x > a ? share(scale * (x - a), b - a) : 0;
  if (x <= c) return scale;
  return x < d ? share(scale * (d - x), d - c) : 0;
}

}  // namespace tactus::fuzzy
