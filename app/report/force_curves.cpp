#include "app/report/force_curves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/figures/force_curves.h"
#include "core/base/error.h"

namespace tactus::report {

namespace {

using base::ErrorCode;

constexpr std::size_t kInputs = 4;

base::Result<std::size_t> placeOf(const fuzzy::ForceModel& model, std::string_view id) {
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (model.inputs[i].id == id) return i;
  }
  return base::fail(ErrorCode::kReference, "/inputs", "no input " + base::quoted(id),
                    "the inputs lubrication, neck_flexion, depth and speed");
}

}  // namespace

base::Result<ForceCurves> ForceCurves::of(const fuzzy::ForceModel& model) {
  TACTUS_TRY(auto compiled, fuzzy::compile(model));
  if (model.inputs.size() != kInputs) {
    return base::fail(ErrorCode::kSchema, "/inputs", std::to_string(model.inputs.size()) + " inputs",
                      "the four inputs lubrication, neck_flexion, depth and speed");
  }
  ForceCurves curves(std::move(compiled));
  struct Slot {
    std::string_view id;
    std::size_t ForceCurves::*place;
  };
  const std::array<Slot, kInputs> slots = {{{"lubrication", &ForceCurves::lubrication_},
                                            {"neck_flexion", &ForceCurves::neck_flexion_},
                                            {"depth", &ForceCurves::depth_},
                                            {"speed", &ForceCurves::speed_}}};
  for (const Slot& slot : slots) {
    TACTUS_TRY(const auto place, placeOf(model, slot.id));
    curves.*slot.place = place;
  }
  const fuzzy::Variable& depth = model.inputs[curves.depth_];
  const auto steps = static_cast<std::size_t>(std::ceil(depth.max - depth.min));
  for (std::size_t i = 0; i <= steps; ++i) {
    curves.even_mm_.push_back(std::min(depth.min + static_cast<double>(i), depth.max));
  }
  curves.plotted_mm_ = figures::samplePositions(model, curves.depth_);
  return curves;
}

std::optional<double> ForceCurves::force(const CurveSetting& setting, double depth_mm,
                                         std::optional<std::size_t> expert) const {
  std::array<double, kInputs> inputs{};
  inputs[lubrication_] = setting.lubrication;
  inputs[neck_flexion_] = setting.neck_flexion_deg;
  inputs[depth_] = depth_mm;
  inputs[speed_] = setting.speed_mm_s;
  const fuzzy::Evaluation out = expert ? compiled_.evaluateExpert(*expert, inputs) : compiled_.evaluate(inputs);
  if (!out.fired) return std::nullopt;
  return out.force_n;
}

ForceCurve ForceCurves::at(const std::vector<double>& depths_mm, const CurveSetting& setting,
                           std::optional<std::size_t> expert) const {
  ForceCurve out;
  out.reserve(depths_mm.size());
  for (const double depth_mm : depths_mm) out.push_back({depth_mm, force(setting, depth_mm, expert)});
  return out;
}

ForceCurve ForceCurves::curve(const CurveSetting& setting, std::optional<std::size_t> expert) const {
  return at(even_mm_, setting, expert);
}

ForceCurve ForceCurves::plotted(const CurveSetting& setting, std::optional<std::size_t> expert) const {
  return at(plotted_mm_, setting, expert);
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
