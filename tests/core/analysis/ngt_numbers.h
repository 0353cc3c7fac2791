// The variables of the model of the nasogastric tube by index, and the just-noticeable difference, for the tests.
#pragma once

#include <cmath>
#include <cstddef>

namespace tactus::analysis {

enum Variable : std::size_t { kLubrication, kFlexion, kDepth, kSpeed, kForce };

/// sqrt(0.04² + (0.12 F)²) N.
inline double noticeable(double force_n) { return std::hypot(.04, .12 * force_n); }

}  // namespace tactus::analysis
