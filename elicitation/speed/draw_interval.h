// From the spread of bootstrap draws to an interval that covers what it promises, few strokes or many.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace tactus::elicitation {

/// Probability with which an interval is to hold the true value, unless the caller asks for another.
inline constexpr double kCoverage = 0.95;

/// How every interval of the speeds is made, for those who print one.
inline constexpr std::string_view kIntervalMethod = "student_t_of_draws";

struct Interval {
  double low = 0;
  double high = 0;
};

/// What the strokes of a value say of its draws: n strokes drawn from n vary by (n - 1) / n of the variance that n new
/// strokes would have, and that variance is known with n - 1 degrees of freedom.
struct DrawSpread {
  double widening = 1;  ///< of the variance of the draws: n / (n - 1)
  double degrees = 1;   ///< of freedom: n - 1
};

/// Of n >= 2 strokes.
DrawSpread spreadOf(std::size_t strokes);

/// Of a value whose variance is the sum of independent parts: `variances` (>= 0) of the draws of each part, and what
/// its strokes say. The degrees of freedom are the mean weighted by the widened variances, harmonic: strokes of one
/// person, whose parts the value mixes. Without any variance the fewest degrees.
DrawSpread mixedSpread(std::span<const double> variances, std::span<const DrawSpread> parts);

/// The same for the mean of several persons, whose variances are estimated independently (Welch 1947, Satterthwaite
/// 1946): more degrees of freedom than each person has.
DrawSpread pooledSpread(std::span<const double> variances, std::span<const DrawSpread> persons);

/// value +- t * sqrt(widening) * standard deviation of `draws`, t with the degrees of freedom of `spread`; its lower
/// end is not below `lowest`, which the value cannot leave. Covers 92 to 97 % for a nominal 95 % of 4, 6 and 12 strokes
/// a level, where the middle 95 % of the draws cover 77 to 90 % (Hesterberg 2015; tests/elicitation/
/// interval_coverage_test.cpp). `coverage` in [0, 1).
Interval drawInterval(double value, const std::vector<double>& draws, const DrawSpread& spread, double lowest,
                      double coverage);

}  // namespace tactus::elicitation
