// Force over depth from a force model: what the curves, the surface and the checklist are drawn and computed from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/svg_plot.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::report {

/// All inputs but the depth.
struct CurveSetting {
  double lubrication = 1;       ///< 0 to 1
  double neck_flexion_deg = 0;  ///< 0 to 90
  double speed_mm_s = 0;
};

struct CurvePoint {
  double depth_mm = 0;
  std::optional<double> force_n;  ///< nothing where no rule fires
};
using ForceCurve = std::vector<CurvePoint>;

/// Evaluates a model of the four inputs `lubrication`, `neck_flexion`, `depth`, `speed`, in whatever order it has them.
class ForceCurves {
 public:
  /// Compiles `model`. Refused: a model that does not validate, or with other inputs.
  static base::Result<ForceCurves> of(const fuzzy::ForceModel& model);

  /// The force of one expert (index into the model's experts), or without one the averaged force.
  std::optional<double> force(const CurveSetting& setting, double depth_mm, std::optional<std::size_t> expert) const;

  /// The force from one end of the depth's universe to the other, a value every `step_mm` > 0.
  ForceCurve curve(const CurveSetting& setting, std::optional<std::size_t> expert, double step_mm = 1) const;

  double depthMin() const { return depth_min_mm_; }
  double depthMax() const { return depth_max_mm_; }

 private:
  explicit ForceCurves(fuzzy::CompiledModel compiled) : compiled_(std::move(compiled)) {}

  fuzzy::CompiledModel compiled_;
  std::size_t lubrication_ = 0, neck_flexion_ = 0, depth_ = 0, speed_ = 0;  ///< places among the inputs
  double depth_min_mm_ = 0;
  double depth_max_mm_ = 0;
};

/// The curve as a series to plot.
Series toSeries(const ForceCurve& curve);

/// Smallest and largest force among the points that have one; nothing if none has.
struct ForceRange {
  double low_n = 0;
  double high_n = 0;
};
std::optional<ForceRange> forceRange(const ForceCurve& curve);

/// The forces that the averaged model takes anywhere on a grid over all four inputs: what can come out at all. The
/// centroid of a set is inside the set, so the ends of the output's universe never do.
std::optional<ForceRange> reachableRange(const fuzzy::ForceModel& model, const ForceCurves& curves);

}  // namespace tactus::report
