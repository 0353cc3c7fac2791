#include "core/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/check.h"

namespace tactus::base {

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

}  // namespace tactus::base
