// Derivatives of the centroid of one expert's output set.
#pragma once

#include <array>
#include <span>

#include "core/fuzzy/centroid.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// The derivatives of the centroid with respect to one term.
struct SetGradient {
  std::array<double, 4> points;  ///< with respect to a, b, c, d, or to mean and sigma
  double log_strength;           ///< with respect to ln(strength): strength * dF/dstrength
};

/// Returns the centroid F over [lo, hi] of the pointwise maximum of the terms, measured from `lo`, and writes its
/// derivatives to `out`. The terms are clipped at their strengths or scaled by them. `terms`: 1 to kMostTerms; each
/// overlaps [lo, hi] in positive width.
///
/// With the maximum A(y): dF = 1/area * integral of (y - F) dA(y). Where a term is highest, dA with respect to its
/// strength or to a vertex is linear in y, so all integrals are closed forms. Gaussians are integrated by quadrature.
/// On a ramp the integral runs over the height instead of y, so it also holds for a vertical edge, the limit of steep
/// ramps.
/// Thread: any. Real-time safe: yes.
double centroidGradient(std::span<const fuzzy::ActiveTerm> terms, fuzzy::Implication implication, double lo, double hi,
                        std::span<SetGradient> out) noexcept;

}  // namespace tactus::analysis
