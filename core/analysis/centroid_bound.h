// A lower bound on the centroid of every output set that given terms can form. Internal to the bounds on the force.
#pragma once

#include <vector>

#include "core/analysis/term_moments.h"

namespace tactus::analysis {

/// The largest error of the moments, as a share of the universe, with a wide margin.
inline constexpr double kRounding = 1e-12;

/// Largest c in [0, width] that is proved to be a lower bound of the centroid, as described in force_bounds.h; short of
/// it by less than kRounding * width. `terms`, not empty, are on a universe that starts at 0. `clip`: at any strength
/// up to that of the term; otherwise the terms are scaled.
double lowerCentroidBound(const std::vector<BoundedTerm>& terms, bool clip, double width);

}  // namespace tactus::analysis
