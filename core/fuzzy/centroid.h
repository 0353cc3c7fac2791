// Exact centroid of the aggregated output set.
#pragma once

#include <span>

#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::fuzzy {

/// An output term and the strength with which it fires.
struct ActiveTerm {
  const MembershipFunction* function;
  double strength;  ///< in (0, 1]
  double height;    ///< strength relative to the largest one, in (0, 1]; exact also where strengths are subnormal
};

/// Centroid over [lo, hi] of the pointwise maximum of the terms, each clipped at its strength or scaled by it, measured
/// from `lo`. At least one term and at most kMostTerms; each must meet [lo, hi] in positive width.
///
/// Trapezoids: the maximum is piecewise linear, so area and moment are sums of closed forms over the pieces between all
/// vertices and crossings; nothing is sampled. Heights are taken relative to the largest strength, so tiny strengths
/// keep full precision. Where a Gaussian is active: see gaussianCentroid. Thread: any. Real-time safe: yes.
double centroidOffset(std::span<const ActiveTerm> terms, Implication implication, double lo, double hi) noexcept;

/// The same where Gaussians are among the terms. Crossings are bracketed and bisected to the last bit; between them
/// linear pieces are integrated in closed form and Gaussian pieces by ten-point Gauss-Legendre quadrature on parts so
/// short that its error is below rounding. Bound: 1e-12 of hi - lo.
double gaussianCentroidOffset(std::span<const ActiveTerm> terms, Implication implication, double lo,
                              double hi) noexcept;

/// Area and first moment of a piecewise function, added up from its pieces.
struct AreaAndMoment {
  double area = 0;
  double moment = 0;

  /// Adds the trapezoid of `width` from position x0 on, with heights y0 and y1 at its ends. The width comes apart from
  /// the position because a difference of positions would lose the width of a set a few ulps wide.
  void addLinear(double x0, double width, double y0, double y1) noexcept {
    const double piece = width * (y0 + y1) / 2;
    area += piece;
    moment += piece * x0 + width * width * (y0 + 2 * y1) / 6;
  }
};

}  // namespace tactus::fuzzy
