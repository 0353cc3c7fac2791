#include "core/fuzzy/support.h"

#include <cmath>
#include <limits>

namespace tactus::fuzzy {
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
