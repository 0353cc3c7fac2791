#include "core/fuzzy/gaussian_pieces.h"

#include <utility>

namespace tactus::fuzzy {
namespace {

/// A point in [left, right] where `f` changes its sign, to the last bit; f(left) and f(right) differ in sign.
template <class F>
double bisect(const F& f, double left, double right) noexcept {
  const bool rising = f(left) <= 0;
  while (true) {
    const double middle = left + (right - left) / 2;
    if (middle <= left || middle >= right) return middle;
    ((f(middle) <= 0) == rising ? left : right) = middle;
  }
}

}  // namespace

double* writeCrossings(const CurvePiece& p, const CurvePiece& q, double x0, double x1, double* out) noexcept {
  // Between two Gaussians the logarithm of the quotient has the sign of the difference, and is a parabola.
  const bool both = p.curved && q.curved;
  const auto difference = [&](double x) {
    if (!both) return p.at(x) - q.at(x);
    const double u = (x - p.mean) / p.sigma;
    const double v = (x - q.mean) / q.sigma;
    return (p.log_scale - q.log_scale) - 0.5 * (u - v) * (u + v);
  };
  // Split at the extremum of the difference, so that each part holds at most one crossing.
  double middle = x1;
  if (both) {
    const double pp = 1 / (p.sigma * p.sigma);
    const double qq = 1 / (q.sigma * q.sigma);
    if (pp != qq) middle = (p.mean * pp - q.mean * qq) / (pp - qq);
  } else {
    const auto slope = [&](double x) { return p.slopeAt(x) - q.slopeAt(x); };
    if ((slope(x0) <= 0) != (slope(x1) <= 0)) middle = bisect(slope, x0, x1);
  }
  middle = middle > x0 && middle < x1 ? middle : x1;
  for (const auto& [left, right] : {std::pair{x0, middle}, std::pair{middle, x1}}) {
    if (left < right && (difference(left) <= 0) != (difference(right) <= 0)) *out++ = bisect(difference, left, right);
  }
  return out;
}

}  // namespace tactus::fuzzy
