// What an item without an answer leaves open.
#pragma once

#include <optional>
#include <vector>

#include "core/analysis/coverage.h"
#include "core/analysis/force_probe.h"
#include "core/fuzzy/force_model.h"

namespace tactus::elicitation {

/// How far an expert's force depends on an answer that was not given.
struct AnswerStake {
  double newtons = 0;         ///< largest minus smallest force over all answers
  std::vector<double> point;  ///< where; the conditions of the item hold in full there
};

/// The stake of a rule with `conditions` that expert number `expert` might have given, with each output term as its
/// consequent beside the expert's other rules: the largest one over at most `samples` settings of the inputs that the
/// conditions do not mention. Nothing where the conditions do not resolve, can never hold in full, or already have a
/// rule.
std::optional<AnswerStake> answerStake(const analysis::ForceProbe& probe, std::size_t expert,
                                       const std::vector<fuzzy::Condition>& conditions, std::size_t samples);

/// Whether a rule of `expert` with `conditions` would fire somewhere inside `hole`.
bool wouldFireIn(const analysis::Hole& hole, const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                 const std::vector<fuzzy::Condition>& conditions);

}  // namespace tactus::elicitation
