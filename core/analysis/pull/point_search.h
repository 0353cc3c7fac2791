// All edits at a point: the gestures of all lists that are not locked, and the edits of rules.
#pragma once

#include <span>
#include <vector>

#include "core/analysis/pull/gesture_search.h"
#include "core/analysis/pull/pull.h"
#include "core/analysis/pull/rule_search.h"

namespace tactus::analysis {

struct PointSearch {
  std::vector<SearchedGesture> gestures;
  std::vector<SearchedRule> rules;  ///< of a model of one expert

  /// The gesture that comes nearest to the target, and the rule.
  const SearchedGesture* nearestGesture(double target_n) const;
  const SearchedRule* nearestRule(double target_n) const;
};

PointSearch searchPoint(const PointForce& point, double target_n, const PullSettings& settings);

/// Pairs of edits that give the target: `first`, and after it one edit more.
std::vector<std::vector<PullEdit>> pairsWith(const PullEdit& first, const fuzzy::ForceModel& model,
                                             std::span<const double> point, double target_n,
                                             const PullSettings& settings);

}  // namespace tactus::analysis
