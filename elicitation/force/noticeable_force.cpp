#include "elicitation/force/noticeable_force.h"

#include <algorithm>
#include <cmath>

#include "core/contracts/contract_check.h"

namespace tactus::elicitation {

analysis::StepLimits forceStepLimits(const fuzzy::ForceModel& model) {
  analysis::StepLimits limits;
  limits.noticeable = justNoticeableDifference;
  limits.stiffness_n_mm = model.renderer.value_or(fuzzy::RendererParameters{}).stiffness_n_mm;
  return limits;
}

double justNoticeableDifference(double force_n) { return contracts::justNoticeableDifference(force_n); }

StrokeDifference strokeDifference(const fuzzy::CompiledModel& first, const fuzzy::CompiledModel& second,
                                  std::vector<double> point, std::size_t depth_input, double from_mm, double to_mm) {
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(to_mm - from_mm)));
  StrokeDifference out;
  double squares = 0;
  double sum_n = 0;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double depth_mm = std::lerp(from_mm, to_mm, static_cast<double>(i) / static_cast<double>(steps));
    point[depth_input] = depth_mm;
    const auto a = first.evaluate(point);
    const auto b = second.evaluate(point);
    if (!a.fired || !b.fired) {
      ++out.without_one;
      continue;
    }
    const double difference_n = b.force_n - a.force_n;
    const double jnd = std::abs(difference_n) / justNoticeableDifference(a.force_n);
    squares += jnd * jnd;
    sum_n += difference_n;
    ++out.places;
    if (jnd <= out.largest_jnd) continue;
    out.largest_jnd = jnd;
    out.largest_n = difference_n;
    out.at_mm = depth_mm;
  }
  if (out.places == 0) return out;
  out.rms_jnd = std::sqrt(squares / static_cast<double>(out.places));
  out.mean_n = sum_n / static_cast<double>(out.places);
  return out;
}

}  // namespace tactus::elicitation
