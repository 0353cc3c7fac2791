#include "elicitation/agreement/alpha_interval.h"

#include <vector>

#include "core/base/random.h"
#include "core/base/statistics.h"

namespace tactus::elicitation {
std::optional<AlphaInterval> alphaInterval(const RatingCounts& counts, AlphaLevel level,
                                           const AlphaIntervalSettings& settings) {
  const std::size_t units = counts.units.size();
  if (units < 2) return std::nullopt;
  base::Random random(settings.seed);
  std::vector<double> alphas;
  RatingCounts draw = counts;
  for (std::size_t i = 0; i < settings.draws; ++i) {
    if (settings.stop.stop_requested()) return std::nullopt;
    for (auto& unit : draw.units) unit = counts.units[static_cast<std::size_t>(random.below(static_cast<int>(units)))];
    if (const auto alpha = krippendorffAlpha(draw, level)) alphas.push_back(*alpha);
  }
  if (alphas.size() * 2 < settings.draws) return std::nullopt;
  const double tail = (1 - settings.level) / 2;
  return AlphaInterval{base::quantile(alphas, tail), base::quantile(alphas, 1 - tail), alphas.size()};
}

}  // namespace tactus::elicitation
