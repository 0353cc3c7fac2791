// How far a model is from a reference curve, and the delta of a gesture that comes nearest.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/analysis/pull/pull_curve.h"
#include "core/analysis/pull/ramps.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::analysis {

class ReferenceFit {
 public:
  /// Points of `reference` at which `compiled` has no force are left out.
  ReferenceFit(const fuzzy::CompiledModel& compiled, const ReferenceCurve& reference,
               const NoticeableDifference& noticeable);

  std::size_t points() const noexcept { return reference_.low_n.size(); }
  std::size_t leftOut() const noexcept { return left_out_; }

  struct Residual {
    double rms_n = 0;
    double rms_noticeable = 0;  ///< in noticeable differences around the reference
  };
  /// What is left. Nothing if a point has no force.
  std::optional<Residual> of(const fuzzy::CompiledModel& model) const;
  /// The same for the model after an edit; nothing if it is not valid either.
  std::optional<Residual> after(const fuzzy::ForceModel& model, const PullEdit& edit) const;

  /// The delta of `edit` within `range` that leaves least; of several that leave nothing, the smallest. Nothing if none
  /// changes what is left.
  std::optional<double> best(const fuzzy::ForceModel& model, PullEdit edit, const DeltaRange& range) const;

 private:
  ReferenceCurve reference_;
  std::vector<double> noticeable_n_;
  std::size_t left_out_ = 0;
};

}  // namespace tactus::analysis
