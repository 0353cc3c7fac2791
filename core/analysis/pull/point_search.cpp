#include "core/analysis/pull/point_search.h"

#include <algorithm>
#include <cmath>

namespace tactus::analysis {

const SearchedGesture* PointSearch::nearestGesture(double target_n) const {
  const SearchedGesture* nearest = nullptr;
  for (const SearchedGesture& one : gestures) {
    if (!one.reach.nearest) continue;
    const double off = std::abs(one.reach.nearest->force_n - target_n);
    if (nearest == nullptr || off < std::abs(nearest->reach.nearest->force_n - target_n)) nearest = &one;
  }
  return nearest;
}

const SearchedRule* PointSearch::nearestRule(double target_n) const {
  const auto nearest = std::min_element(rules.begin(), rules.end(), [&](const auto& one, const auto& other) {
    return std::abs(one.force_n - target_n) < std::abs(other.force_n - target_n);
  });
  return nearest == rules.end() ? nullptr : &*nearest;
}

PointSearch searchPoint(const PointForce& point, double target_n, const PullSettings& settings) {
  PointSearch out;
  const bool alone = point.model().experts.size() == 1;
  for (const PulledList& list : listsOf(point.model(), !alone)) {
    if (std::find(settings.locked.begin(), settings.locked.end(), list.variable) != settings.locked.end()) continue;
    auto found = searchList(point, list, target_n);
    out.gestures.insert(out.gestures.end(), found.begin(), found.end());
  }
  if (alone && !settings.lock_rules) out.rules = searchRules(point, 0, target_n);
  return out;
}

std::vector<std::vector<PullEdit>> pairsWith(const PullEdit& first, const fuzzy::ForceModel& model,
                                             std::span<const double> point, double target_n,
                                             const PullSettings& settings) {
  const fuzzy::ForceModel after = applied(model, first);
  const PointForce there(after, point);
  std::vector<std::vector<PullEdit>> out;
  if (!there.now()) return out;
  for (SearchedGesture& one : searchPoint(there, target_n, settings).gestures) {
    if (!one.reach.exact || *one.reach.exact == 0) continue;
    one.edit.delta = *one.reach.exact;
    out.push_back({first, one.edit});
  }
  return out;
}

}  // namespace tactus::analysis
