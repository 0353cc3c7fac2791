// Fleiss' kappa: agreement of several raters on unordered categories.
#pragma once

#include "elicitation/agreement/ratings.h"

namespace tactus::elicitation {

struct FleissKappa {
  double kappa = 0;           ///< 1 for full agreement, 0 for agreement by chance
  double standard_error = 0;  ///< of kappa, if the ratings are random
  double z = 0;               ///< kappa / standard_error
  double p = 1;               ///< two-sided, from the normal distribution
  long long ratings_per_unit = 0;
};

/// Fleiss 1971; standard error under chance by Fleiss, Nee and Landis 1979. No result if units have different numbers
/// of ratings or fewer than two, if there are no units, or if all ratings are equal.
OrReason<FleissKappa> fleissKappa(const RatingCounts& counts);

}  // namespace tactus::elicitation
