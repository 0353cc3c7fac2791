#include "app/report/force_curves.h"

#include <algorithm>
#include <cmath>

#include "app/figures/force_curves.h"
#include "core/base/error.h"

namespace tactus::report {

base::Result<ForceCurves> ForceCurves::of(const fuzzy::ForceModel& model) {
  TACTUS_TRY(auto compiled, fuzzy::compile(model));
  const auto way = fuzzy::wayOf(model.inputs);
  if (!way) {
    return base::fail(base::ErrorCode::kReference, "/inputs", "no input of the role `way`",
                      "an input along which the tip moves");
  }
  ForceCurves curves(std::move(compiled), *way);
  const fuzzy::Variable& depth = model.inputs[*way];
  const auto steps = static_cast<std::size_t>(std::ceil(depth.max - depth.min));
  for (std::size_t i = 0; i <= steps; ++i) {
    curves.even_mm_.push_back(std::min(depth.min + static_cast<double>(i), depth.max));
  }
  curves.plotted_mm_ = figures::samplePositions(model, *way);
  return curves;
}

std::optional<double> ForceCurves::force(std::vector<double> at, double depth_mm,
                                         std::optional<std::size_t> expert) const {
  at[way_] = depth_mm;
  const fuzzy::Evaluation out = expert ? compiled_.evaluateExpert(*expert, at) : compiled_.evaluate(at);
  if (!out.fired) return std::nullopt;
  return out.force_n;
}

ForceCurve ForceCurves::along(const std::vector<double>& depths_mm, std::vector<double> at,
                              std::optional<std::size_t> expert) const {
  ForceCurve out;
  out.reserve(depths_mm.size());
  for (const double depth_mm : depths_mm) out.push_back({depth_mm, force(at, depth_mm, expert)});
  return out;
}

ForceCurve ForceCurves::curve(const std::vector<double>& at, std::optional<std::size_t> expert) const {
  return along(even_mm_, at, expert);
}

ForceCurve ForceCurves::plotted(const std::vector<double>& at, std::optional<std::size_t> expert) const {
  return along(plotted_mm_, at, expert);
}

Series toSeries(const ForceCurve& curve) {
  Series out;
  for (const CurvePoint& point : curve) out.push_back({point.depth_mm, point.force_n});
  return out;
}

std::optional<ForceRange> forceRange(const ForceCurve& curve) {
  std::optional<ForceRange> range;
  for (const CurvePoint& point : curve) {
    if (!point.force_n) continue;
    if (!range) range = ForceRange{*point.force_n, *point.force_n};
    range->low_n = std::min(range->low_n, *point.force_n);
    range->high_n = std::max(range->high_n, *point.force_n);
  }
  return range;
}

}  // namespace tactus::report
