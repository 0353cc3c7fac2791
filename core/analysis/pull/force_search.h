// The search for the place where a force along one number meets a target.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/pull/point_force.h"
#include "core/analysis/pull/pull_edit.h"

namespace tactus::analysis {

/// What an edit of one rule can do to the force at a point.
struct SearchedRule {
  PullEdit edit;
  double force_n = 0;
};

/// All edits of one rule of expert number `expert` that fires at the point and that leave a force there: each other
/// word, off, and the weight nearest to the present one that gives the target, where there is one. Words that would
/// make the same rule twice are left out.
std::vector<SearchedRule> searchRules(const PointForce& point, std::size_t expert, double target_n);

/// All words and offs of the expert's rules that take part, at no point: `force_n` is not set.
std::vector<PullEdit> ruleEdits(const fuzzy::ForceModel& model, std::size_t expert);

/// The number of steps between neighboring rules that go against the prevailing direction of `expert`, over all inputs.
std::size_t stepsAgainstDirection(const fuzzy::ForceModel& model, std::size_t expert);

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

// What each gesture on the lists of terms can do to the force at a point.

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
