// What each gesture on the lists of terms can do to the force at a point.
#pragma once

#include <vector>

#include "core/analysis/pull/force_search.h"
#include "core/analysis/pull/point_force.h"

namespace tactus::analysis {

/// A gesture on a list of terms, with `edit.delta` 0.
struct SearchedGesture {
  PullEdit edit;
  DeltaRange range;  ///< of the delta, by the order of the vertices
  Reach reach;
};

/// The gestures of a list of an input or of the output that some expert reads. In a list that sums to one, one
/// membership decides: the force depends on a ramp only through the membership u of its left term at the point, so F(u)
/// is looked at 65 places and at its bends, and each gesture follows in closed form. Output terms, and lists that do
/// not sum to one (their single vertices), are searched by delta.
std::vector<SearchedGesture> searchList(const PointForce& point, const PulledList& list, double target_n);

/// All gestures of a list, without a search.
std::vector<SearchedGesture> gesturesOfList(const fuzzy::ForceModel& model, const PulledList& list);

/// The lists of a model that some expert's rules read: of each variable the shared one, then the experts' own.
/// `shared_only` leaves out the experts' own ones.
std::vector<PulledList> listsOf(const fuzzy::ForceModel& model, bool shared_only);

}  // namespace tactus::analysis
