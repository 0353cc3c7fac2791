#include "core/analysis/force_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/force_probe.h"
#include "core/analysis/sample_points.h"
#include "core/base/check.h"

namespace tactus::analysis {

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
