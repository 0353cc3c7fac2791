#include "core/analysis/force_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/force_probe.h"
#include "core/analysis/sample_points.h"
#include "core/base/check.h"

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

std::vector<std::vector<double>> boxPoints(const fuzzy::ForceModel& model, std::size_t count) {
  std::vector<std::vector<double>> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < model.inputs.size(); ++k) {
      const auto& input = model.inputs[k];
      points[i].push_back(input.min + halton(i + 1, k) * (input.max - input.min));
    }
  }
  return points;
}

std::vector<std::vector<double>> linePoints(const fuzzy::ForceModel& model, const std::vector<double>& at,
                                            std::size_t input, std::size_t count) {
  const auto& variable = model.inputs[input];
  std::vector<std::vector<double>> points(count, at);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0;
    points[i][input] = i + 1 == count ? variable.max : variable.min + share * (variable.max - variable.min);
  }
  return points;
}

ForceDifference forceDifference(const fuzzy::ForceModel& first, const fuzzy::CompiledModel& compiled_first,
                                const fuzzy::ForceModel& second, const fuzzy::CompiledModel& compiled_second) {
  TACTUS_CHECK(first.inputs.size() == second.inputs.size());
  constexpr std::size_t kUnbounded = std::numeric_limits<std::size_t>::max();
  ForceProbe one(first, compiled_first, kUnbounded);
  ForceProbe two(second, compiled_second, kUnbounded);
  const std::size_t most = affordablePoints(1 + one.costOfMean() + two.costOfMean());

  ForceDifference out;
  double squares = 0;
  std::size_t even_points = 0;
  const auto compare = [&](std::vector<double> point, bool counts_for_rms) {
    const auto a = one.mean(point);
    const auto b = two.mean(point);
    if (a.fired != b.fired) ++out.only_one_fires;
    if (!a.fired || !b.fired) return;
    ++out.points;
    const double newtons = std::abs(a.force_n - b.force_n);
    if (counts_for_rms) {
      squares += newtons * newtons;
      ++even_points;
    }
    if (newtons <= out.largest_n) return;
    out.largest_n = newtons;
    out.at = std::move(point);
    out.first_n = a.force_n;
    out.second_n = b.force_n;
  };
  const SamplePoints kinks = kinkPoints(first, most);
  for (std::size_t p = 0; p < kinks.size(); ++p) compare(kinks[p], false);
  const SamplePoints spread = evenPoints(first, most);
  for (std::size_t p = 0; p < spread.size(); ++p) compare(spread[p], true);
  if (even_points > 0) out.rms_n = std::sqrt(squares / static_cast<double>(even_points));
  return out;
}

}  // namespace tactus::analysis
