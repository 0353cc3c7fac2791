#include "core/fuzzy/gaussian_pieces.h"

#include <utility>

namespace tactus::fuzzy {
namespace {

/// A point in [left, right] where `f` changes its sign, to the last bit; f(left) and f(right) differ in sign.
/// Secants that give way to a bisection where they do not halve the interval in three steps (Illinois).
template <class F>
double bisect(const F& f, double left, double right) noexcept {
  double before = f(left);
  double after = f(right);
  const bool rising = before <= 0;
  double aim = (right - left) / 2;  // the next width that shows progress
  for (int step = 1;; ++step) {
    const double middle = left + (right - left) / 2;
    if (middle <= left || middle >= right) return middle;
    double next = left + (right - left) * (before / (before - after));
    if (step % 3 == 0) {
      if (right - left > aim) next = middle;
      aim = (right - left) / 2;
    }
    if (!(next > left && next < right)) next = middle;
    const double value = f(next);
    if ((value <= 0) == rising) {
      left = next;
      before = value;
      after /= 2;
    } else {
      right = next;
      after = value;
      before /= 2;
    }
  }
}

}  // namespace

double* writeCrossings(const CurvePiece& p, const CurvePiece& q, double x0, double x1, double* out) noexcept {
  // The logarithm of the quotient has the sign of the difference. Between two Gaussians, or one and a plateau, it is a
  // parabola.
  const bool both = p.curved && q.curved;
  const auto is_plateau = [](const CurvePiece& piece) { return !piece.curved && piece.slope == 0 && piece.y0 > 0; };
  const bool plateau = (p.curved && is_plateau(q)) || (q.curved && is_plateau(p));
  const double log_height = plateau ? std::log(p.curved ? q.y0 : p.y0) : 0;
  const auto difference = [&](double x) {
    const double u = (x - p.mean) / p.sigma;
    const double v = (x - q.mean) / q.sigma;
    if (both) return (p.log_scale - q.log_scale) - 0.5 * (u - v) * (u + v);
    if (plateau) return p.curved ? (p.log_scale - log_height) - 0.5 * u * u : (log_height - q.log_scale) + 0.5 * v * v;
    return p.at(x) - q.at(x);
  };
  // Split at the extremum of the difference, so that each part holds at most one crossing.
  double middle = x1;
  if (both) {
    const double pp = 1 / (p.sigma * p.sigma);
    const double qq = 1 / (q.sigma * q.sigma);
    if (pp != qq) middle = (p.mean * pp - q.mean * qq) / (pp - qq);
  } else if (plateau) {
    middle = p.curved ? p.mean : q.mean;
  } else if (p.curved || q.curved) {
    const auto slope = [&](double x) { return p.slopeAt(x) - q.slopeAt(x); };
    if ((slope(x0) <= 0) != (slope(x1) <= 0)) middle = bisect(slope, x0, x1);
  }
  middle = middle > x0 && middle < x1 ? middle : x1;
  for (const auto& [left, right] : {std::pair{x0, middle}, std::pair{middle, x1}}) {
    if (left >= right) continue;
    const double before = difference(left);
    const double after = difference(right);
    if ((before <= 0) == (after <= 0)) continue;
    const bool lines = !p.curved && !q.curved;
    *out++ = lines ? left + (right - left) * (before / (before - after)) : bisect(difference, left, right);
  }
  return out;
}

}  // namespace tactus::fuzzy
