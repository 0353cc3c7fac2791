#include "core/fuzzy/membership.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tactus::fuzzy {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Vertices nearer to 0 than this, but not 0, and ramps narrower than this are left to the general path.
constexpr double kTiny = 1e-280;

/// numerator / denominator for positive arguments, never rounded down to 0.
double share(double numerator, double denominator) noexcept {
  return std::max(numerator / denominator, std::numeric_limits<double>::denorm_min());
}

/// 1 / width, rounded so that width * the result is at least 1.
double steepness(double width) {
  double slope = 1 / width;
  while (width * slope < 1) slope = std::nextafter(slope, kInfinity);
  return slope;
}

/// One ramp from `foot` (membership 0) to `shoulder` (1); `outward` is the direction from shoulder to foot. False where
/// the general path must take it.
bool setRamp(double foot, double shoulder, double outward, double& position, double& slope) {
  const double width = std::abs(shoulder - foot);
  const auto is_tiny = [](double x) { return x != 0 && std::abs(x) < kTiny; };
  if (width == 0) {
    // A vertical edge: a ramp one ulp wide that ends at the edge.
    if (std::abs(foot) < kTiny) return false;
    position = std::nextafter(foot, outward);
    slope = std::numeric_limits<double>::max();
    return true;
  }
  if (width < kTiny || is_tiny(foot) || is_tiny(shoulder)) return false;
  position = foot;
  slope = steepness(width);
  return true;
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

std::optional<Ramps> rampsOf(const MembershipFunction& f, double lo, double hi) {
  Ramps ramps;
  if (f.gaussian) return std::nullopt;
  ramps.has_rise = f.b > lo;
  ramps.has_fall = f.c < hi;
  if (ramps.has_rise && !setRamp(f.a, f.b, -kInfinity, ramps.a, ramps.rise)) return std::nullopt;
  if (ramps.has_fall && !setRamp(f.d, f.c, kInfinity, ramps.d, ramps.fall)) return std::nullopt;
  return ramps;
}

namespace {

/// The last number on the way from the mean of a Gaussian, where it is 1, to `outside`, where it is 0, that has a
/// membership above 0.
double lastAbove0(const MembershipFunction& gaussian, double outside) noexcept {
  double inside = gaussian.mean;
  while (true) {
    const double middle = inside + (outside - inside) / 2;
    if (middle == inside || middle == outside) return inside;
    (gaussian(middle) > 0 ? inside : outside) = middle;
  }
}

}  // namespace

Support supportOf(const MembershipFunction& function) noexcept {
  if (!function.gaussian) return {function.a, function.d};
  constexpr double kFar = 80;  // sigma, with one digit more where sigma is below the distance of neighboring numbers
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {lastAbove0(function, std::nextafter(function.mean - kFar * function.sigma, -kInfinity)),
          lastAbove0(function, std::nextafter(function.mean + kFar * function.sigma, kInfinity))};
}

}  // namespace tactus::fuzzy
