// Force over depth from a force model: the numbers behind the curves, the surface and the checklist.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/svg_plot.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::report {

struct CurvePoint {
  double depth_mm = 0;
  std::optional<double> force_n;  ///< nothing if no rule fires
};
using ForceCurve = std::vector<CurvePoint>;

/// Evaluates a model along its way. `at` holds one value for each input; that of the way is not used.
class ForceCurves {
 public:
  /// Compiles `model`. Refused: an invalid model, or a model without an input of the role `way`.
  static base::Result<ForceCurves> of(const fuzzy::ForceModel& model);

  /// The force of one expert (index into the model's experts); without an expert the averaged force.
  std::optional<double> force(std::vector<double> at, double depth_mm, std::optional<std::size_t> expert) const;

  /// The force over the depth's universe at even places, one point every mm.
  ForceCurve curve(const std::vector<double>& at, std::optional<std::size_t> expert) const;
  /// The same for a plot, at the places of figures::samplePositions: kinks, jumps and ends of gaps are exact.
  ForceCurve plotted(const std::vector<double>& at, std::optional<std::size_t> expert) const;

  double depthMin() const { return even_mm_.front(); }
  double depthMax() const { return even_mm_.back(); }
  const fuzzy::CompiledModel& compiled() const { return compiled_; }

 private:
  ForceCurves(fuzzy::CompiledModel compiled, std::size_t way) : compiled_(std::move(compiled)), way_(way) {}
  ForceCurve along(const std::vector<double>& depths_mm, std::vector<double> at,
                   std::optional<std::size_t> expert) const;

  fuzzy::CompiledModel compiled_;
  std::size_t way_;                           ///< index of the input
  std::vector<double> even_mm_, plotted_mm_;  ///< places along the depth
};

/// The curve as a series for a plot.
Series toSeries(const ForceCurve& curve);

/// Smallest and largest force among the points that have one; nothing if none has.
struct ForceRange {
  double low_n = 0;
  double high_n = 0;
};
std::optional<ForceRange> forceRange(const ForceCurve& curve);

}  // namespace tactus::report
