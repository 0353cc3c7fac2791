// The content of Table 1: mean and standard deviation of the insertion speed, per participant and level.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/study/records.h"

namespace tactus::experiments {

struct SpeedSummary {
  std::string participant;
  std::string level;
  std::size_t strokes = 0;
  std::size_t samples = 0;
  double mean_mm_s = 0;
  double sd_mm_s = 0;  ///< n - 1 in the denominator; 0 for one sample
};

/// One summary per participant and level, over all samples of their strokes (paper, Table 1), in the order of first
/// appearance in `samples`.
std::vector<SpeedSummary> summarizeSpeeds(std::span<const study::SpeedSample> samples);

}  // namespace tactus::experiments
