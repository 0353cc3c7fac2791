// The rules of one expert with indices instead of names; only enabled rules with a weight > 0.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

// Steps between neighboring rules of an expert along an input, and the change of the force level of each.

/// Two rules of one expert with the same conditions except for the term of one input, and no rule for a term between.
struct NeighborStep {
  std::size_t input = 0;   ///< index of the input along which the step goes
  std::size_t before = 0;  ///< index in Expert::rules of the rule with the lower term
  std::size_t after = 0;
  int levels = 0;  ///< places from the first to the second consequent in the order of the output terms; may be < 0
  bool adjacent = false;  ///< no term of the expert lies between; false: the rule for a term between is missing

  bool operator==(const NeighborStep&) const = default;
};

/// All steps of `expert` along input number `input`. Input and output terms are ordered by their centers. Terms with
/// the same center share a place, so there is no step or level between them. If a rule occurs twice with different
/// consequents, each makes its own steps. Disabled rules and rules of weight 0 do not count. `model` must be valid.
std::vector<NeighborStep> neighborSteps(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, std::size_t input);

/// `speed from slow to fast where depth is stomach, force from small to large`
std::string describe(const NeighborStep& step, const fuzzy::ForceModel& model, const fuzzy::Expert& expert);

/// `depth is nasopharynx and speed is slow`, sorted by input.
std::string describe(std::vector<fuzzy::Condition> conditions);

struct ResolvedRule {
  std::size_t index = 0;         ///< in Expert::rules
  std::uint64_t conditions = 0;  ///< packed: seven bits per input, 0 without a condition, else term + 1
  std::size_t then = 0;          ///< index of the output term
  double weight = 1;

  /// Index of the term in the condition on `input`, or -1.
  int termOf(std::size_t input) const noexcept { return static_cast<int>(conditions >> (7 * input) & 0x7F) - 1; }
};

/// `model` must be valid and `expert` one of its experts.
std::vector<ResolvedRule> resolveRules(const fuzzy::ForceModel& model, const fuzzy::Expert& expert);

/// A position in [min, max] with the largest membership of `term` there: the middle of its core, or the end next to it.
double peakPosition(const fuzzy::Term& term, double min, double max);

/// For each output term of `expert`: the largest strength that a rule can give it, which is weight times the smallest
/// peak of its conditions over the universe. 0 if the term is no rule's consequent.
std::vector<double> largestStrengths(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                                     std::span<const ResolvedRule> rules);

/// The largest firing strength of one rule, computed in the same way.
double largestStrength(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const ResolvedRule& rule);

// Rules that contradict each other, have no effect or never fire.

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
