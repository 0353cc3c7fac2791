#include "app/report/force_curves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/check.h"

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
  auto compiled = fuzzy::compile(model);
  if (!compiled) return tl::unexpected(compiled.error());
  if (model.inputs.size() != kInputs) {
    return base::fail(ErrorCode::kSchema, "/inputs", std::to_string(model.inputs.size()) + " inputs",
                      "the four inputs lubrication, neck_flexion, depth and speed");
  }
  ForceCurves curves(std::move(*compiled));
  struct Slot {
    std::string_view id;
    std::size_t ForceCurves::*place;
  };
  const std::array<Slot, kInputs> slots = {{{"lubrication", &ForceCurves::lubrication_},
                                            {"neck_flexion", &ForceCurves::neck_flexion_},
                                            {"depth", &ForceCurves::depth_},
                                            {"speed", &ForceCurves::speed_}}};
  for (const Slot& slot : slots) {
    const auto place = placeOf(model, slot.id);
    if (!place) return tl::unexpected(place.error());
    curves.*slot.place = *place;
  }
  curves.depth_min_mm_ = model.inputs[curves.depth_].min;
  curves.depth_max_mm_ = model.inputs[curves.depth_].max;
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

ForceCurve ForceCurves::curve(const CurveSetting& setting, std::optional<std::size_t> expert, double step_mm) const {
  TACTUS_CHECK(step_mm > 0);
  ForceCurve out;
  const auto steps = static_cast<std::size_t>(std::ceil((depth_max_mm_ - depth_min_mm_) / step_mm));
  for (std::size_t i = 0; i <= steps; ++i) {
    const double depth_mm = std::min(depth_min_mm_ + static_cast<double>(i) * step_mm, depth_max_mm_);
    out.push_back({depth_mm, force(setting, depth_mm, expert)});
  }
  return out;
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

std::optional<ForceRange> reachableRange(const fuzzy::ForceModel& model, const ForceCurves& curves) {
  // Coarse where the terms are flat, and the ends, where the extremes are.
  constexpr int kSteps = 6;
  constexpr double kDepthSteps = 60;
  const auto along = [&](std::string_view id, int step) {
    for (const fuzzy::Variable& input : model.inputs) {
      if (input.id == id) return input.min + (input.max - input.min) * step / kSteps;
    }
    return 0.0;
  };
  std::optional<ForceRange> range;
  const double step_mm = (curves.depthMax() - curves.depthMin()) / kDepthSteps;
  for (int lubrication = 0; lubrication <= kSteps; ++lubrication) {
    for (int flexion = 0; flexion <= kSteps; ++flexion) {
      for (int speed = 0; speed <= kSteps; ++speed) {
        const auto found = forceRange(
            curves.curve({along("lubrication", lubrication), along("neck_flexion", flexion), along("speed", speed)},
                         std::nullopt, step_mm));
        if (!found) continue;
        if (!range) range = found;
        range->low_n = std::min(range->low_n, found->low_n);
        range->high_n = std::max(range->high_n, found->high_n);
      }
    }
  }
  return range;
}

}  // namespace tactus::report
