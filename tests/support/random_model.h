// Random force models for property tests: ordinary ones and adversarial ones.
#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/fuzzy/force_model.h"

namespace tactus::support {

struct RandomModelOptions {
  bool gaussians = false;   ///< some terms are Gaussian
  bool adversarial = true;  ///< odd universes, edges a few ulps apart, strengths down to 1e-300
};

/// A valid model: 1..4 inputs, 1..6 terms each, 1..4 experts, some with their own terms; trapezoids and triangles with
/// vertical edges, coincident vertices, points outside the universe and gaps between terms; clip or scale.
fuzzy::ForceModel randomModel(base::Random& random, const RandomModelOptions& options = {});

/// A point for `model`: anywhere in the universes, on a vertex, a few ulps beside one, or outside.
std::vector<double> randomPoint(base::Random& random, const fuzzy::ForceModel& model);

/// Gives the experts weights between the smallest and the largest double, in any order; none is 0.
void takeExtremeWeights(base::Random& random, fuzzy::ForceModel& model);

}  // namespace tactus::support
