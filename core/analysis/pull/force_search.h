// The search for the place where a force along one number meets a target.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/pull/ramps.h"

namespace tactus::analysis {

/// The force at a value of the number; nothing in a hole.
using ForceAt = std::function<std::optional<double>(double)>;

/// A value of the number and the force there.
struct ForcePoint {
  double at = 0;
  double force_n = 0;
};

/// What one gesture can do.
struct Reach {
  std::optional<double> exact;        ///< the smallest delta, by its size, that gives the target
  std::optional<ForcePoint> nearest;  ///< the delta that comes nearest
  double min_n = 0;                   ///< of the looks; meaningless without `nearest`
  double max_n = 0;

  /// Notes a look. A force within rounding of the target is exact.
  void look(double delta, double force_n, double target_n);
  /// Notes a delta that gives the target.
  void meets(double delta, double target_n);
};

/// The number of even steps over a range.
inline constexpr int kSteps = 64;

/// `points` (ascending `at`): all places where the force is `target_n`: those of the points themselves and one in each
/// interval between neighbors across which the force passes the target, to the last bits of the force.
std::vector<double> crossings(std::span<const ForcePoint> points, const ForceAt& force, double target_n);

/// What deltas in `range` do, from 64 even steps on each side of 0 and the `bends` inside.
Reach searchDeltas(const DeltaRange& range, const ForceAt& force, double target_n, std::span<const double> bends = {});

}  // namespace tactus::analysis
