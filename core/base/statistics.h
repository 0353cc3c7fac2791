// Descriptive statistics of one sample, and the distribution functions that tests need.
#pragma once

#include <span>
#include <vector>

namespace tactus::base {

/// Arithmetic mean of a sample that is not empty.
double mean(std::span<const double> sample);

/// Standard deviation with n - 1 in the denominator (two passes); 0 for fewer than two values.
double standardDeviation(std::span<const double> sample);

/// Quantile by linear interpolation (type 7 of Hyndman and Fan 1996). `share`: [0, 1]. The sample must not be empty.
double quantile(std::vector<double> sample, double share);

inline double median(std::vector<double> sample) { return quantile(std::move(sample), 0.5); }

/// The share of a normal distribution below `z` standard deviations.
double normalShare(double z);

/// Regularised incomplete beta function I_x(a, b), a and b > 0. `y`: 1 - x, given for its digits.
/// Abramowitz and Stegun 26.5.8.
double incompleteBeta(double a, double b, double x, double y);

}  // namespace tactus::base
