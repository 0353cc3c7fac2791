// The effect of a missing answer.
#pragma once

#include <optional>
#include <vector>

#include "core/analysis/coverage.h"
#include "core/analysis/force_probe.h"
#include "core/fuzzy/force_model.h"

namespace tactus::elicitation {

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

}  // namespace tactus::elicitation
