// What an edit of one rule can do to the force at a point.
#pragma once

#include <vector>

#include "core/analysis/pull/force_search.h"
#include "core/analysis/pull/point_force.h"

namespace tactus::analysis {

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

}  // namespace tactus::analysis
