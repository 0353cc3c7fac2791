#include "app/workbench/understand/curves/force_spread.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/check.h"

namespace tactus::workbench {

ForceSpread spreadOf(const figures::ForceCurves& curves, std::span<const double> weights) {
  TACTUS_CHECK(weights.size() == curves.experts.size());
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::size_t count = curves.x.size();
  ForceSpread spread{std::vector<double>(count, kNone), std::vector<double>(count, kNone),
                     std::vector<double>(count, kNone), std::vector<double>(count, kNone),
                     std::vector<double>(count, kNone)};
  for (std::size_t i = 0; i < count; ++i) {
    double lowest = HUGE_VAL;
    double highest = -HUGE_VAL;
    double weight = 0;
    double weight_squared = 0;
    double squares = 0;
    std::size_t speaking = 0;
    for (std::size_t expert = 0; expert < weights.size(); ++expert) {
      const fuzzy::Evaluation& here = curves.experts[expert][i];
      if (!here.fired || !(weights[expert] > 0)) continue;
      ++speaking;
      lowest = std::min(lowest, here.force_n);
      highest = std::max(highest, here.force_n);
      const double share = weights[expert];
      const double off = here.force_n - curves.mean[i].force_n;
      weight += share;
      weight_squared += share * share;
      squares += share * off * off;
    }
    if (speaking >= 2) {
      spread.lowest_n[i] = lowest;
      spread.highest_n[i] = highest;
    }
    if (speaking >= kFewestForDeviation) {
      const double deviation = std::sqrt(squares / (weight - weight_squared / weight));
      spread.deviation_n[i] = deviation;
      spread.minus_sd_n[i] = curves.mean[i].force_n - deviation;
      spread.plus_sd_n[i] = curves.mean[i].force_n + deviation;
    }
  }
  return spread;
}

}  // namespace tactus::workbench
