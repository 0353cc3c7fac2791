// Fleiss' kappa: agreement of several raters on categories without order.
#pragma once

#include "elicitation/agreement/ratings.h"

namespace tactus::elicitation {

struct FleissKappa {
  double kappa = 0;           ///< 1 for full agreement, 0 for what chance gives
  double standard_error = 0;  ///< of kappa where the ratings are left to chance
  double z = 0;               ///< kappa / standard_error
  double p = 1;               ///< two-sided, from the normal distribution
  long long ratings_per_unit = 0;
};

/// Fleiss 1971; the standard error under chance of Fleiss, Nee and Landis 1979. No result where units have different
/// numbers of ratings or fewer than two, where there is no unit, or where all ratings are the same.
OrReason<FleissKappa> fleissKappa(const RatingCounts& counts);

}  // namespace tactus::elicitation
