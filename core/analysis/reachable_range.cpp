#include "core/analysis/reachable_range.h"

#include <algorithm>
#include <limits>

#include "core/analysis/force_probe.h"
#include "core/analysis/sample_points.h"

namespace tactus::analysis {

ForceRange reachableRange(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                          const std::stop_token& stop) {
  ForceProbe probe(model, compiled, std::numeric_limits<std::size_t>::max(), stop);
  const SamplePoints points = kinkPoints(model, affordablePoints(probe.costOfMean()));

  ForceRange range;
  SamplePoints::Choice lowest;
  SamplePoints::Choice highest;
  const auto look = [&](const SamplePoints::Choice& choice) -> std::optional<double> {
    ++range.points;
    const auto force = probe.mean(points.at(choice));
    if (!force.fired) return std::nullopt;
    if (range.fired == 0 || force.force_n < range.min_n) range.min_n = force.force_n, lowest = choice;
    if (range.fired == 0 || force.force_n > range.max_n) range.max_n = force.force_n, highest = choice;
    ++range.fired;
    return force.force_n;
  };
  for (std::size_t p = 0; p < points.size() && probe.affords(); ++p) look(points.choice(p));
  if (range.fired == 0) return range;
  points.climb(highest, range.max_n, look);
  points.climb(lowest, -range.min_n, [&](const SamplePoints::Choice& choice) -> std::optional<double> {
    const auto force = look(choice);
    return force ? std::optional(-*force) : std::nullopt;
  });
  return range;
}

}  // namespace tactus::analysis
