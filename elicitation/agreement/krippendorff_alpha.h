// Krippendorff's alpha: agreement of any number of raters, with missing ratings and ordered categories.
#pragma once

#include "elicitation/agreement/ratings.h"

namespace tactus::elicitation {

/// The measure of the difference between two categories.
enum class AlphaLevel {
  kNominal,   ///< any two categories are equally different
  kOrdinal,   ///< by the number of ratings between them
  kInterval,  ///< by the number of categories between them
};

/// 1 for full agreement, 0 for agreement by chance, below 0 for disagreement beyond chance. Computed from the
/// coincidence matrix; skips units with fewer than two ratings (Krippendorff 2011). The ordinal difference of
/// categories c < k is that of the mid-ranks of all paired ratings: n_c/2 + n_(c+1) + … + n_k/2, squared. No result if
/// no unit has two ratings, or if all paired ratings are equal.
OrReason<double> krippendorffAlpha(const RatingCounts& counts, AlphaLevel level);

}  // namespace tactus::elicitation
