// The rules of one expert with indices instead of names; only enabled rules with a weight > 0.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

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

}  // namespace tactus::analysis
