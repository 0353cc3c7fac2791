// Rules that contradict each other, have no effect or never fire.
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

/// Rules with the conditions of an earlier rule (`other`) and another consequent.
std::vector<RulePair> conflicts(const std::vector<ResolvedRule>& rules);

/// Rules that can all be removed together without changing any strength of an output term, to the last bit. `other` has
/// the same consequent, a subset of the conditions and a weight at least as large. So it fires at least as strongly as
/// `rule` everywhere.
std::vector<RulePair> redundantRules(const std::vector<ResolvedRule>& rules, std::size_t input_count);

/// The force of one rule alone, which fires with `strength` in (0, 1]: the centroid of its output term, clipped or
/// scaled.
double forceOfTerm(const fuzzy::ForceModel& model, const fuzzy::Term& term, double strength);

}  // namespace tactus::analysis
