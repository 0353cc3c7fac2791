// One model under every evaluator, against exact rationals and against each other.
#pragma once

#include <optional>
#include <string>

#include "core/base/random.h"
#include "core/fuzzy/force_model.h"

namespace tactus::stress {

/// What was found on one model.
struct Agreement {
  std::optional<std::string> disagreement;  ///< the first one beyond the bounds, in words
  double largest_share = 0;                 ///< error against exact rationals, in parts of the bound
  double largest_ulps = 0;                  ///< batch or scene against one point, see entryPointUlps
};

/// Evaluates `model` (trapezoids and triangles) at `points` random points by `evaluate`, `evaluateExpert`,
/// `evaluateBatch`, `Scene::evaluate` and `Scene::evaluateBatch`, a random subset of the inputs fixed in the scene, and
/// at one point that is not finite. Bounds: `fired` as exact arithmetic says; the force within 1e-12 of the output's
/// range and 2 ulp of the exact one; batch and scene within 4 ulp and the same bound of one point.
Agreement checkBuildment(const fuzzy::ForceModel& model, base::Random& random, int points);

/// How many ulps `a` and `b` are apart, both forces over a universe that begins at `output_min`. A force is the lower
/// end of the universe and an offset; where these cancel, an ulp is one of the offset.
double entryPointUlps(double a, double b, double output_min);

}  // namespace tactus::stress
