// Krippendorff's alpha: agreement of any number of raters, with missing ratings and ordered categories.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>

#include "elicitation/agreement/agreement_data.h"

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

/// An interval for Krippendorff's alpha: how much it depends on which units were rated.
struct AlphaInterval {
  double low = 0;
  double high = 0;
  std::size_t draws = 0;  ///< draws that gave an alpha
};

struct AlphaIntervalSettings {
  double level = 0.95;  ///< in (0, 1)
  std::size_t draws = 2'000;
  std::uint64_t seed = 1;
  std::stop_token stop = {};
};

/// Draws the units (forces, items) with replacement and takes the quantiles of alpha. The raters stay: the interval
/// says nothing about other raters. A draw in which all ratings are equal has no alpha and does not count. Nothing for
/// fewer than two units, if fewer than half of the draws have an alpha, or after a stop request. The same arguments
/// give the same interval.
std::optional<AlphaInterval> alphaInterval(const RatingCounts& counts, AlphaLevel level,
                                           const AlphaIntervalSettings& settings = {});

}  // namespace tactus::elicitation
