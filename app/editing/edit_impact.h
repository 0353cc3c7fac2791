// The effect of an edit on the averaged force, in newtons and just-noticeable differences, computed fast.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/coverage.h"
#include "core/analysis/force_difference.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::editing {

/// The difference of the averaged force of two models over the same inputs, where both fire.
struct EditImpact {
  double largest_n = 0;    ///< largest |difference| found
  std::vector<double> at;  ///< its place, one value per input; empty if there is no difference
  double before_n = 0;     ///< the forces there
  double after_n = 0;
  /// Largest difference in just-noticeable differences around the force before (elicitation/force/noticeable_force.h).
  /// It may be at another point. Below 1 no person feels the edit.
  double noticeable = 0;
  std::size_t points = 0;  ///< number of compared points
  std::size_t opened = 0;  ///< points at which an expert had a force before and none has one now
  std::size_t closed = 0;  ///< the reverse
};

/// The region in which the two models can differ: one range per input, the hull of the changed terms and of the
/// conditions of changed rules. Empty if no number that affects the force changed.
std::vector<analysis::InputRange> changedRegion(const fuzzy::ForceModel& before, const fuzzy::ForceModel& after);

/// Compares a bounded sample of points; this is no proof. At most 4,096 combinations of the vertices of both models
/// inside the changed region and the middles between them, and about as many again near the worst point; fewer if the
/// models have many experts or rules. Measured: 1.5 ms for one expert with 45 rules, 12 ms for 256 of them that share
/// their terms. Both models must be valid, with the same input ids; the compiled ones are made from them.
/// Deterministic. Thread: any.
EditImpact editImpact(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
                      const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after);

// The ghost of an edit: the model before it, kept beside the model after it, to compare forces and draw both curves.

/// The forces of the two models along one input, at the same points.
struct GhostCurve {
  struct Point {
    double at = 0;  ///< value of the varied input
    double before_n = 0;
    double after_n = 0;
    bool before_fired = false;
    bool after_fired = false;
  };
  std::vector<Point> points;
  double largest_n = 0;  ///< largest |difference| on the curve, where both fire
  std::optional<double> largest_at;
  double before_n = 0;  ///< the forces there
  double after_n = 0;
  double noticeable = 0;  ///< largest difference in just-noticeable differences around the force before
  std::optional<double> noticeable_at;
  std::size_t opened = 0;  ///< places that had a force before and have none now
  std::size_t closed = 0;  ///< the reverse
};

/// Both forces along input `input` at the ascending `places`. `point` gives the values of the other inputs: one value
/// per input; both models have the same inputs. Refused: a value that is not finite, no place.
base::Result<GhostCurve> ghostCurve(const fuzzy::CompiledModel& before, const fuzzy::CompiledModel& after,
                                    std::size_t input, std::span<const double> point, std::span<const double> places);

/// Raises `impact` to the differences of a curve of the same two models. The curve varies input `input`; the other
/// inputs are as in `point`. So the reported effect of an edit is never less than the curve on the screen shows.
/// Returns whether `impact` grew.
bool include(EditImpact& impact, const GhostCurve& curve, std::size_t input, std::span<const double> point);

/// Two states of one model, over the same inputs. Copies share their data.
class ModelGhost {
 public:
  /// Both models must be valid; the compiled ones are made from them.
  ModelGhost(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
             const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after);

  /// The region in which the force can have changed, one range per input; empty if it cannot have changed.
  const std::vector<analysis::InputRange>& region() const { return region_; }
  const fuzzy::CompiledModel& before() const { return compiled_before_; }
  const fuzzy::CompiledModel& after() const { return compiled_after_; }

  /// Both forces along input `input` over its whole universe, at `count` >= 2 points. `point` gives the values of the
  /// other inputs (one value per input). Refused: a value that is not finite, too few points.
  base::Result<GhostCurve> curve(std::size_t input, std::span<const double> point, std::size_t count) const;

  /// The difference over the whole universe, with the root mean square. Takes some hundredths of a second.
  analysis::ForceDifference difference() const;

 private:
  fuzzy::ForceModel model_before_;
  fuzzy::ForceModel model_after_;
  fuzzy::CompiledModel compiled_before_;
  fuzzy::CompiledModel compiled_after_;
  std::vector<analysis::InputRange> region_;
};

}  // namespace tactus::editing
