// Why no single edit gives a wanted force (PullBlocker).
#pragma once

#include <optional>
#include <vector>

#include "core/analysis/pull/gesture_search.h"
#include "core/analysis/pull/point_force.h"
#include "core/analysis/pull/pull.h"
#include "core/analysis/pull/rule_search.h"

namespace tactus::analysis {

/// The word whose centroid is the limit: no strength of any word of the experts gives a centroid on the target's side
/// of all. Holds while the output terms stay as they are.
std::optional<PullBlocker> centroidLimit(const PointForce& point, double target_n);

/// What stops the gesture at the delta that comes nearest to the target.
PullBlocker whereItStops(const fuzzy::ForceModel& model, const SearchedGesture& gesture);

}  // namespace tactus::analysis
