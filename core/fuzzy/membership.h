// Membership functions in the form used for evaluation.
#pragma once

#include <optional>

#include "core/fuzzy/force_model.h"

namespace tactus::fuzzy {

/// A trapezoid (a triangle has b = c) or a Gaussian.
struct MembershipFunction {
  bool gaussian = false;
  double a = 0, b = 0, c = 0, d = 0;  ///< trapezoid
  double mean = 0, sigma = 1;         ///< Gaussian

  /// Converts a term that `validate` accepts.
  static MembershipFunction of(const Term& term) noexcept;

  /// Membership of x in [0, 1].
  /// A trapezoid is 0 outside [a, d] and 1 on [b, c]. If a = b or c = d, that edge is vertical and has membership 1.
  /// Strictly inside the support, the membership is never rounded down to 0. So a rule fires exactly if it fires in
  /// real arithmetic.
  /// A Gaussian is exp(-((x - mean) / sigma)^2 / 2).
  /// Thread: any. Real-time safe: yes.
  double operator()(double x) const noexcept { return scaled(x, 1); }

  /// `scale` times the membership. Keeps the digits that the membership alone would lose below the normal range of
  /// double.
  double scaled(double x, double scale) const noexcept;

  bool operator==(const MembershipFunction&) const = default;
};

/// A trapezoid of an input: the smaller of two ramps, cut to [0, 1].
struct Ramps {
  double a = 0, rise = 0;  ///< (x - a) * rise; `rise` is rounded so that the ramp reaches 1 where the core begins
  double d = 0, fall = 0;  ///< (d - x) * fall
  bool has_rise = true;    ///< false if the membership is 1 from the lower end of the universe on
  bool has_fall = true;
};

/// The ramps of a trapezoid on the universe [lo, hi]. Nothing for a Gaussian, and for a trapezoid so narrow or so near
/// to 0 that they would lose digits: the general path takes it.
std::optional<Ramps> rampsOf(const MembershipFunction& f, double lo, double hi);

// Where a membership is above 0.

/// The closed range outside which the membership is 0.
struct Support {
  double low = 0;
  double high = 0;
};

/// Of a trapezoid its feet; of a Gaussian where the exponential underflows, about 38.6 sigma from the mean, to the last
/// digit. There the Gaussian ends like a vertical edge: beyond, the evaluation finds that no rule fires.
Support supportOf(const MembershipFunction& function) noexcept;

}  // namespace tactus::fuzzy
