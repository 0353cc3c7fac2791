// Derivatives of the centroid of one expert's output set.
#pragma once

#include <array>
#include <span>

#include "core/fuzzy/centroid.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// What one term does to the centroid.
struct SetGradient {
  std::array<double, 4> points;  ///< with respect to a, b, c, d, or to mean and sigma
  double log_strength;           ///< with respect to the logarithm of the strength: strength * dF/dstrength
};

/// Centroid F over [lo, hi] of the pointwise maximum of the terms, clipped at or scaled by their strengths, measured
/// from `lo`, and into `out` its derivatives. At least one term and at most kMostTerms; each must meet [lo, hi] in
/// positive width.
///
/// With A(y) the maximum, dF = 1/area * integral of (y - F) dA(y). Where a term is highest, dA with respect to its
/// strength or to a vertex is linear in y, so all integrals are closed forms; Gaussians are integrated by quadrature.
/// On a ramp the integral runs over the height instead of y, and so it also holds for a vertical edge, the limit of
/// steep ramps. Thread: any. Real-time safe: yes.
double centroidGradient(std::span<const fuzzy::ActiveTerm> terms, fuzzy::Implication implication, double lo, double hi,
                        std::span<SetGradient> out) noexcept;

}  // namespace tactus::analysis
