// The rules of one expert with names resolved to indices: only those that count, that is, enabled ones of a weight > 0.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

struct ResolvedRule {
  std::size_t index = 0;         ///< in Expert::rules
  std::uint64_t conditions = 0;  ///< packed: seven bits per input, 0 where there is no condition, else term + 1
  std::size_t then = 0;          ///< index of the output term
  double weight = 1;

  /// Index of the term in the condition on `input`, or -1.
  int termOf(std::size_t input) const noexcept { return static_cast<int>(conditions >> (7 * input) & 0x7F) - 1; }
};

/// `model` must be valid and `expert` one of its experts.
std::vector<ResolvedRule> resolveRules(const fuzzy::ForceModel& model, const fuzzy::Expert& expert);

/// A point of [min, max] where `term` is as large as it gets there: the middle of its core, or the end next to it.
double peakPosition(const fuzzy::Term& term, double min, double max);

/// For each output term of `expert` the largest strength that a rule can give it: weight times the smallest peak of its
/// conditions, each taken over the universe. 0 where no rule ever concludes the term.
std::vector<double> largestStrengths(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                                     std::span<const ResolvedRule> rules);

/// Largest firing strength of one rule, as above.
double largestStrength(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const ResolvedRule& rule);

}  // namespace tactus::analysis
