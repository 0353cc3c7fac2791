// Rules that contradict each other, change nothing or never fire.
#pragma once

#include <vector>

#include "core/analysis/rule_table.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// Two rules by their index in Expert::rules.
struct RulePair {
  std::size_t rule = 0;
  std::size_t other = 0;
};

/// Rules with the conditions of an earlier one (`other`) and another consequent.
std::vector<RulePair> conflicts(const std::vector<ResolvedRule>& rules);

/// Rules that can be removed, all at once, without changing the strength of an output term anywhere, to the last bit:
/// `other` has the same consequent, some of the conditions and no further one, and a weight at least as large, so it
/// fires at least as strongly wherever `rule` does.
std::vector<RulePair> redundantRules(const std::vector<ResolvedRule>& rules, std::size_t input_count);

/// Force of one rule alone at full strength `strength` in (0, 1]: the centroid of the output term, clipped or scaled.
double forceOfTerm(const fuzzy::ForceModel& model, const fuzzy::Term& term, double strength);

}  // namespace tactus::analysis
