// Compares the clusters of a participant's speeds with the requested levels.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/study/records.h"

namespace tactus::elicitation {

/// A table of requested levels against clusters. The clustering itself ignores the levels.
struct LevelConfusion {
  std::vector<std::string> levels;               ///< as given, slow to fast
  std::vector<std::vector<std::size_t>> counts;  ///< counts[level][cluster]: samples by nearest center
  std::size_t other_levels = 0;                  ///< samples of a level that is not in `levels`
  double accuracy = 0;                           ///< share of the samples whose cluster is that of their level
  double adjusted_rand_index = 0;                ///< agreement beyond chance (Hubert and Arabie 1985); 1 is perfect
  std::vector<std::string> warnings;             ///< one sentence each, naming `participant`
};

/// The table of one participant's samples for `centres` (ascending). Warns if the adjusted Rand index is below 0.3 or
/// the accuracy below 0.6.
LevelConfusion levelConfusion(std::span<const study::SpeedSample> samples, std::span<const std::string> levels,
                              std::span<const double> centres, const std::string& participant);

}  // namespace tactus::elicitation
