// The model before an edit, kept beside the one after it: where the force changed and by how much, and curves of both.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/editing/edit_impact.h"
#include "core/analysis/force_difference.h"
#include "core/base/error.h"

namespace tactus::editing {

/// The forces of the two models along one input, at the same points.
struct GhostCurve {
  struct Point {
    double at = 0;  ///< of the input that varies
    double before_n = 0;
    double after_n = 0;
    bool before_fired = false;
    bool after_fired = false;
  };
  std::vector<Point> points;
  double largest_n = 0;  ///< largest |difference| on the curve where both fire
  std::optional<double> largest_at;
  double before_n = 0;  ///< the forces there
  double after_n = 0;
  double noticeable = 0;  ///< largest one in just-noticeable differences around the force before
  std::optional<double> noticeable_at;
  std::size_t opened = 0;  ///< places that had a force before and have none now
  std::size_t closed = 0;  ///< the other way round
};

/// Both forces along input number `input` at `places`, ascending, the other inputs at the values of `point` (one per
/// input of both models, which have the same ones). Refused: a value that is not finite, no place.
base::Result<GhostCurve> ghostCurve(const fuzzy::CompiledModel& before, const fuzzy::CompiledModel& after,
                                    std::size_t input, std::span<const double> point, std::span<const double> places);

/// Takes into `impact` what was seen along a curve of the same two models, input number `input` varying and the others
/// as in `point`: what an edit does is at least what the curve on the screen shows.
/// Returns whether `impact` grew.
bool include(EditImpact& impact, const GhostCurve& curve, std::size_t input, std::span<const double> point);

/// Two states of one model, over the same inputs. Copies share what they hold.
class ModelGhost {
 public:
  /// Both valid, compiled from the models given.
  ModelGhost(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
             const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after);

  /// Where the force can have changed at all; empty where it cannot. One range per input.
  const std::vector<analysis::InputRange>& region() const { return region_; }
  const fuzzy::CompiledModel& before() const { return compiled_before_; }
  const fuzzy::CompiledModel& after() const { return compiled_after_; }

  /// Both forces along input number `input` from end to end of its universe, at `count` >= 2 points, the other inputs
  /// at the values of `point` (one per input). Refused: a value that is not finite, too few points.
  base::Result<GhostCurve> curve(std::size_t input, std::span<const double> point, std::size_t count) const;

  /// Over the whole universe, with the root mean square; some hundredths of a second.
  analysis::ForceDifference difference() const;

 private:
  fuzzy::ForceModel model_before_;
  fuzzy::ForceModel model_after_;
  fuzzy::CompiledModel compiled_before_;
  fuzzy::CompiledModel compiled_after_;
  std::vector<analysis::InputRange> region_;
};

}  // namespace tactus::editing
