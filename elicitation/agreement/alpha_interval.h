// An interval for Krippendorff's alpha: how much it depends on which units were rated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>

#include "elicitation/agreement/krippendorff_alpha.h"

namespace tactus::elicitation {

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
