// Findings about the rules of a model, for the researcher. A finding names the expert, the rule and the difference of
// forces in N.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/coverage.h"
#include "core/analysis/force_probe.h"
#include "core/analysis/lint.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/rules/expert_rules.h"

namespace tactus::elicitation {

// The effect of a missing answer.

/// How much an expert's force depends on a missing answer.
struct AnswerStake {
  double newtons = 0;         ///< largest minus smallest force over all answers
  std::vector<double> point;  ///< the point of that difference; it fully meets the conditions of the item
};

/// The stake of a missing rule with `conditions` of expert number `expert`. Tries each output term as its consequent,
/// together with the expert's other rules. Returns the largest stake over at most `samples` settings of the inputs that
/// the conditions do not mention. Nothing if the conditions are unknown, can never be fully met, or already have a
/// rule.
std::optional<AnswerStake> answerStake(const analysis::ForceProbe& probe, std::size_t expert,
                                       const std::vector<fuzzy::Condition>& conditions, std::size_t samples);

/// Whether a rule of `expert` with `conditions` would fire somewhere inside `hole`.
bool wouldFireIn(const analysis::Hole& hole, const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                 const std::vector<fuzzy::Condition>& conditions);

/// A finding with what the study knows of it. Its text is one sentence, with the sources.
struct RuleFinding : analysis::Finding {
  /// A rule, or an item without a rule.
  struct Source {
    std::optional<std::size_t> rule;  ///< index in Expert::rules; empty for an item without an answer
    RuleOrigin origin;                ///< empty if only the model is known
  };

  std::vector<std::string> experts;  ///< ids; empty for the averaged model
  std::vector<Source> sources;       ///< of the first expert (kExpertsApart: one of each); empty if no rule
                                     ///< is the cause
  bool at_least = false;  ///< `newtons` is the largest value found at the tried settings; others may be larger
};

/// `items 3, 8 (answers.csv, lines 4, 9)`, `rule 2 (rules.csv, line 3)`. Rule numbers count from 1. Empty without
/// sources.
std::string describe(const std::vector<RuleFinding::Source>& sources);

}  // namespace tactus::elicitation
