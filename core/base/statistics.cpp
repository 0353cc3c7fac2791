#include "core/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/check.h"

namespace tactus::base {
namespace {

constexpr double kSmall = 1e-300;
constexpr int kMostTerms = 10000;  // of the continued fraction; some dozens do for all but millions of degrees

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

}  // namespace

double mean(std::span<const double> sample) {
  TACTUS_CHECK(!sample.empty());
  const double count = static_cast<double>(sample.size());
  const double first = std::accumulate(sample.begin(), sample.end(), 0.0) / count;
  // The second pass removes what rounding left in the first.
  double rest = 0;
  for (const double x : sample) rest += x - first;
  return first + rest / count;
}

double standardDeviation(std::span<const double> sample) {
  if (sample.size() < 2) return 0;
  const double centre = mean(sample);
  double squares = 0;
  for (const double x : sample) squares += (x - centre) * (x - centre);
  return std::sqrt(squares / static_cast<double>(sample.size() - 1));
}

double quantile(std::vector<double> sample, double share) {
  TACTUS_CHECK(!sample.empty() && share >= 0 && share <= 1);
  const double position = share * static_cast<double>(sample.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const auto nth = sample.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(sample.begin(), nth, sample.end());
  if (below + 1 == sample.size()) return *nth;
  const double next = *std::min_element(nth + 1, sample.end());
  return *nth + (next - *nth) * (position - static_cast<double>(below));
}

double normalShare(double z) { return std::erfc(-z / std::numbers::sqrt2) / 2; }

double incompleteBeta(double a, double b, double x, double y) {
  if (x <= 0) return 0;
  if (y <= 0) return 1;
  const double front =
      std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log(y));
  return x < (a + 1) / (a + b + 2) ? front * betaFraction(a, b, x) / a : 1 - front * betaFraction(b, a, y) / b;
}

}  // namespace tactus::base
