#include "elicitation/fcm_samples.h"

#include <algorithm>
#include <cmath>

#include "elicitation/fcm.h"

namespace tactus::elicitation {
namespace {

/// The smallest e with |x| <= 2^e; 0 for x = 0.
int exponentAbove(double x) {
  int exponent = 0;
  const double mantissa = std::frexp(std::abs(x), &exponent);
  return mantissa == 0.5 ? exponent - 1 : exponent;
}

}  // namespace

ScaledSamples::ScaledSamples(std::span<const double> samples) : values_(samples.begin(), samples.end()) {
  std::sort(values_.begin(), values_.end());
  for (const double x : values_) {
    if (first_distinct_.size() > kMostClusters) break;
    if (first_distinct_.empty() || x != first_distinct_.back()) first_distinct_.push_back(x);
  }

  // Scaling comes before the shift: the difference of two large values could overflow.
  size_exponent_ = exponentAbove(std::max(std::abs(values_.front()), std::abs(values_.back())));
  for (double& x : values_) x = std::ldexp(x, -size_exponent_);
  median_ = values_[values_.size() / 2];
  spread_exponent_ = exponentAbove(std::max(median_ - values_.front(), values_.back() - median_));
  for (double& x : values_) x = std::ldexp(x - median_, -spread_exponent_);
}

double ScaledSamples::toOriginal(double scaled) const {
  return std::ldexp(median_ + std::ldexp(scaled, spread_exponent_), size_exponent_);
}

CoarseSamples::CoarseSamples(std::span<const double> sorted, std::size_t most) {
  std::size_t distinct = 1;
  for (std::size_t i = 1; i < sorted.size() && distinct <= most; ++i) distinct += sorted[i] != sorted[i - 1] ? 1 : 0;
  const bool exact = distinct <= most;

  // Half of the entries may end because they are wide, the other half because they are heavy.
  const double half = static_cast<double>(most) / 2;
  const double width = exact ? 0 : (sorted.back() - sorted.front()) / half;
  const double heavy = exact ? INFINITY : static_cast<double>(sorted.size()) / half;

  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin;
    double sum = 0;
    while (end < sorted.size() && sorted[end] - sorted[begin] <= width && static_cast<double>(end - begin) < heavy) {
      sum += sorted[end++] - sorted[begin];
    }
    const auto count = static_cast<double>(end - begin);
    values_.push_back(sorted[begin] + sum / count);
    weights_.push_back(count);
    begin = end;
  }
}

}  // namespace tactus::elicitation
