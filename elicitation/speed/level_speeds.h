// The speeds of a participant at each requested level, and the separation of neighboring levels.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/study/records.h"

namespace tactus::elicitation {

/// One level over all its samples, as in Table 1 of the paper.
struct LevelSpeeds {
  std::string level;
  std::size_t samples = 0;
  double mean_mm_s = 0;                   ///< 0 without samples
  double sd_mm_s = 0;                     ///< n - 1 in the denominator; 0 for fewer than two samples
  std::vector<double> stroke_means_mm_s;  ///< one per stroke, in the order of first appearance
};

/// One entry per level of `levels`. `samples`: of one participant; samples of other levels are skipped.
std::vector<LevelSpeeds> levelSpeeds(std::span<const study::SpeedSample> samples, std::span<const std::string> levels);

/// d' = |difference of the means| / pooled standard deviation of the samples (each variance weighted by its samples -
/// 1). Nothing if a level has no samples or no sample varies.
std::optional<double> separation(const LevelSpeeds& one, const LevelSpeeds& other);

}  // namespace tactus::elicitation
