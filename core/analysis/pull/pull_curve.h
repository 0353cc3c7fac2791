// Pulling the force to a reference curve, or into a band, instead of one value at one point.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/pull/pull.h"
#include "core/analysis/pull/pull_edit.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::analysis {

/// The wanted forces at some points.
struct ReferenceCurve {
  std::vector<std::vector<double>>
      columns;                 ///< one per input of the model, as long as the forces; inside the universes
  std::vector<double> low_n;   ///< the force must lie in [low_n, high_n]; equal for a curve, infinite where a
  std::vector<double> high_n;  ///< side is free
};

struct CurveCandidate {
  PullCandidate candidate;     ///< `force_n` at the point; `exact` if the curve is met to the rounding of a delta
  double residual_n = 0;       ///< root mean square of what is left to the reference
  std::size_t same_curve = 0;  ///< other edits that give the same curve and differ elsewhere
};

struct CurvePull {
  double residual_n = 0;     ///< before
  std::size_t left_out = 0;  ///< points of the reference at which no rule fires
  bool close = false;        ///< the best candidate leaves less than a quarter of a noticeable difference (rms)
  std::vector<CurveCandidate> candidates;  ///< best first: plausible before folded, then by what is left, then by k_box
};

/// The edits that bring the force nearest to `reference`: each gesture with its best delta (61 looks, then golden
/// sections) and each edit of a rule that fires somewhere on it, where they gain at least a tenth. If the best
/// plausible one leaves a quarter of a noticeable difference or more, further edits follow on it (greedy, at most three
/// in all, each gains at least a tenth of the rest), and all of them are one candidate. `point`, `settings`, refusals
/// as for `pull`; K at `point`. Also refused: a reference without a point at which a rule fires. Thread: any.
base::Result<CurvePull> pullToCurve(const fuzzy::ForceModel& model, std::span<const double> point,
                                    const ReferenceCurve& reference, const NoticeableDifference& noticeable,
                                    const PullSettings& settings = {});

/// How far a model is from a reference curve, and the delta of a gesture that comes nearest.
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
