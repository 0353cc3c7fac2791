// Krippendorff's alpha: agreement of any number of raters, with missing ratings and with the order of the categories.
#pragma once

#include "elicitation/agreement/ratings.h"

namespace tactus::elicitation {

/// What counts as a difference between two categories.
enum class AlphaLevel {
  kNominal,   ///< any two are equally different
  kOrdinal,   ///< by the ratings that lie between them
  kInterval,  ///< by the number of categories between them
};

/// 1 for full agreement, 0 for what chance gives, below 0 for disagreement beyond chance. From the matrix of
/// coincidences; a unit with fewer than two ratings says nothing and is passed over (Krippendorff 2011). The ordinal
/// difference of categories c < k is that of the mid-ranks of all paired ratings: n_c/2 + n_(c+1) + … + n_k/2, squared.
/// No result where no unit has two ratings, or where all paired ratings are the same.
OrReason<double> krippendorffAlpha(const RatingCounts& counts, AlphaLevel level);

}  // namespace tactus::elicitation
