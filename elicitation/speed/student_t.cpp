#include "elicitation/speed/student_t.h"

#include <cmath>
#include <limits>

#include "core/base/check.h"

namespace tactus::elicitation {
namespace {

constexpr double kSmall = 1e-300;
constexpr int kMostTerms = 10000;  // of the continued fraction; some dozens do for all but millions of degrees
constexpr int kMostHalvings = 200;

/// The continued fraction of the incomplete beta function (Abramowitz and Stegun 26.5.8) by Lentz's method.
double betaFraction(double a, double b, double x) {
  double c = 1;
  double d = 1 / std::fmax(1 - (a + b) * x / (a + 1), kSmall);
  double result = d;
  for (int i = 1; i < kMostTerms; ++i) {
    const double m = i;
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1 / (1 + even * d);
    c = 1 + even / c;
    result *= c * d;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1 / (1 + odd * d);
    c = 1 + odd / c;
    result *= c * d;
    if (std::abs(c * d - 1) < 1e-16) break;
  }
  return result;
}

/// Regularised incomplete beta function I_x(a, b), with y = 1 - x given for its digits.
double incompleteBeta(double a, double b, double x, double y) {
  if (x <= 0) return 0;
  if (y <= 0) return 1;
  const double front =
      std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log(y));
  return x < (a + 1) / (a + b + 2) ? front * betaFraction(a, b, x) / a : 1 - front * betaFraction(b, a, y) / b;
}

/// Probability above t >= 0.
double upperTail(double t, double degrees) {
  const double all = degrees + t * t;
  return incompleteBeta(degrees / 2, 0.5, degrees / all, t * t / all) / 2;
}

}  // namespace

double studentQuantile(double share, double degrees) {
  TACTUS_CHECK(share >= 0 && share <= 1 && degrees > 0);
  if (share < 0.5) return -studentQuantile(1 - share, degrees);
  if (share == 0.5) return 0;
  if (share == 1) return std::numeric_limits<double>::infinity();
  const double tail = 1 - share;
  double low = 0;
  double high = 1;
  while (upperTail(high, degrees) > tail && high < 1e150) {
    low = high;
    high *= 2;
  }
  for (int i = 0; i < kMostHalvings && low < high; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) break;
    (upperTail(middle, degrees) > tail ? low : high) = middle;
  }
  return high;
}

}  // namespace tactus::elicitation
