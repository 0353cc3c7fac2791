// A lower bound on the centroid of all output sets that the given terms can form. Internal to the bounds on the force.
#pragma once

#include <vector>

#include "core/analysis/term_moments.h"

namespace tactus::analysis {

/// Largest error of the moments as a share of the universe, with a wide margin.
inline constexpr double kRounding = 1e-12;

/// The largest c in [0, width] with a proof that c is a lower bound of the centroid (method: force_bounds.h). Too small
/// by less than kRounding * width. `terms`: not empty, on a universe that starts at 0. `clip`: terms are clipped at any
/// strength up to their own; otherwise they are scaled.
double lowerCentroidBound(const std::vector<BoundedTerm>& terms, bool clip, double width);

}  // namespace tactus::analysis
