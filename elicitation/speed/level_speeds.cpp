#include "elicitation/speed/level_speeds.h"

#include <cmath>
#include <map>

#include "core/base/statistics.h"

namespace tactus::elicitation {

std::vector<LevelSpeeds> levelSpeeds(std::span<const study::SpeedSample> samples, std::span<const std::string> levels) {
  std::vector<LevelSpeeds> out;
  for (const auto& level : levels) {
    std::vector<double> all;
    std::vector<std::vector<double>> strokes;
    std::map<int, std::size_t> places;
    for (const auto& sample : samples) {
      if (sample.level != level) continue;
      all.push_back(sample.speed_mm_s);
      const auto place = places.try_emplace(sample.stroke, strokes.size()).first->second;
      if (place == strokes.size()) strokes.emplace_back();
      strokes[place].push_back(sample.speed_mm_s);
    }
    LevelSpeeds one{.level = level, .samples = all.size(), .stroke_means_mm_s = {}};
    if (!all.empty()) one.mean_mm_s = base::mean(all);
    one.sd_mm_s = base::standardDeviation(all);
    for (const auto& stroke : strokes) one.stroke_means_mm_s.push_back(base::mean(stroke));
    out.push_back(std::move(one));
  }
  return out;
}

std::optional<double> separation(const LevelSpeeds& one, const LevelSpeeds& other) {
  if (one.samples == 0 || other.samples == 0 || one.samples + other.samples < 3) return std::nullopt;
  const auto freedom = [](const LevelSpeeds& level) { return static_cast<double>(level.samples) - 1; };
  const double pooled =
      std::sqrt((freedom(one) * one.sd_mm_s * one.sd_mm_s + freedom(other) * other.sd_mm_s * other.sd_mm_s) /
                (freedom(one) + freedom(other)));
  if (pooled == 0) return std::nullopt;
  return std::abs(one.mean_mm_s - other.mean_mm_s) / pooled;
}

}  // namespace tactus::elicitation
