// Membership functions in the form that evaluates.
#pragma once

#include "core/fuzzy/force_model.h"

namespace tactus::fuzzy {

/// A trapezoid (a triangle has b = c) or a Gaussian.
struct MembershipFunction {
  bool gaussian = false;
  double a = 0, b = 0, c = 0, d = 0;  ///< trapezoid
  double mean = 0, sigma = 1;         ///< Gaussian

  /// From a term that `validate` accepts.
  static MembershipFunction of(const Term& term) noexcept;

  /// Membership of x in [0, 1]. A trapezoid is 0 outside [a, d] and 1 on [b, c]; a = b and c = d are vertical edges
  /// with membership 1 at the edge. Strictly inside the support it is never rounded down to 0, so that a rule fires
  /// exactly where real arithmetic says so. A Gaussian is exp(-((x - mean) / sigma)^2 / 2).
  /// Thread: any. Real-time safe: yes.
  double operator()(double x) const noexcept { return scaled(x, 1); }

  /// `scale` times the membership, where the membership alone would lose digits below the normal range of double.
  double scaled(double x, double scale) const noexcept;
};

}  // namespace tactus::fuzzy
