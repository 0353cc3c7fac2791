// Random models that are harder than ordinary adversarial ones.
#pragma once

#include "core/base/random.h"
#include "core/fuzzy/force_model.h"

namespace tactus::stress {

/// A valid model made from support::randomModel with some of: output terms a few ulps to a billionth of the universe
/// wide; output terms that all cross in one point; doubled output terms; strengths down to 1e-300 in every rule; input
/// terms so wide that memberships reach 1e-150. Trapezoids and triangles only.
fuzzy::ForceModel hardModel(base::Random& random);

}  // namespace tactus::stress
