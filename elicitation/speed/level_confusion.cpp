#include "elicitation/speed/level_confusion.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

// Below these the clusters are something else than the levels: strokes simulated to the paper's Table 1 give an index
// of about 0.6 for participants whose levels are apart and 0.1 where the "slow" cluster is the start and stop of
// strokes.
constexpr double kLowRandIndex = 0.3;
constexpr double kLowAccuracy = 0.6;

double pairs(std::size_t count) { return 0.5 * static_cast<double>(count) * (static_cast<double>(count) - 1); }

double adjustedRandIndex(const std::vector<std::vector<std::size_t>>& counts) {
  double together = 0;
  double in_levels = 0;
  double in_clusters = 0;
  std::size_t all = 0;
  std::vector<std::size_t> columns(counts.empty() ? 0 : counts.front().size());
  for (const auto& row : counts) {
    std::size_t row_sum = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
      together += pairs(row[k]);
      row_sum += row[k];
      columns[k] += row[k];
    }
    in_levels += pairs(row_sum);
    all += row_sum;
  }
  for (const std::size_t column : columns) in_clusters += pairs(column);
  if (all < 2) return 1;
  const double chance = in_levels * in_clusters / pairs(all);
  const double most = (in_levels + in_clusters) / 2;
  return most == chance ? 1 : (together - chance) / (most - chance);
}

std::size_t nearestCentre(std::span<const double> centres, double x) {
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < centres.size(); ++k) {
    if (std::abs(x - centres[k]) < std::abs(x - centres[nearest])) nearest = k;
  }
  return nearest;
}

}  // namespace

LevelConfusion levelConfusion(std::span<const study::SpeedSample> samples, std::span<const std::string> levels,
                              std::span<const double> centres, const std::string& participant) {
  LevelConfusion out;
  out.levels.assign(levels.begin(), levels.end());
  out.counts.assign(levels.size(), std::vector<std::size_t>(centres.size()));
  std::size_t right = 0;
  std::size_t counted = 0;
  for (const auto& sample : samples) {
    const auto level = std::find(levels.begin(), levels.end(), sample.level);
    if (level == levels.end()) {
      ++out.other_levels;
      continue;
    }
    const auto row = static_cast<std::size_t>(level - levels.begin());
    const std::size_t cluster = nearestCentre(centres, sample.speed_mm_s);
    ++out.counts[row][cluster];
    ++counted;
    right += row == cluster ? 1 : 0;
  }
  if (out.other_levels > 0) {
    out.warnings.push_back("Participant " + participant + ": " + std::to_string(out.other_levels) +
                           " speed samples have a level that is not one of " + base::joined(levels, ", ") + ".");
  }
  if (counted == 0) return out;
  out.accuracy = static_cast<double>(right) / static_cast<double>(counted);
  out.adjusted_rand_index = adjustedRandIndex(out.counts);
  std::vector<std::string> low;
  if (out.adjusted_rand_index < kLowRandIndex) {
    low.push_back("adjusted Rand index " + base::formatFixed(out.adjusted_rand_index, 2) + ", below 0.3");
  }
  if (out.accuracy < kLowAccuracy) {
    low.push_back("accuracy " + base::formatFixed(out.accuracy, 2) + ", below 0.6");
  }
  if (!low.empty()) {
    out.warnings.push_back("Participant " + participant +
                           ": the samples nearest to each center are not those of the level that was asked for (" +
                           base::joined(low, "; ") +
                           "); the slow cluster may be the start and stop of the strokes, which trimming removes.");
  }
  return out;
}

}  // namespace tactus::elicitation
