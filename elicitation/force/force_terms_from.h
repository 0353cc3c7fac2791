// The terms of the force by any of the ways that lead from the judgements to them.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/force/force_terms.h"
#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {

/// Force terms by ordered probit: one normal curve behind all answers.
struct ProbitTerms : ForceTerms {
  std::vector<double> threshold_n;  ///< one between two terms, ascending or equal
  std::optional<double> sigma_n;    ///< spread of all answers; empty if the likelihood has no maximum
  double answers = 0;               ///< number of answers behind the fit
};

/// The maximum likelihood of study::termThresholds over the answers of all participants together, each answer with
/// equal weight: a force F is felt as F + N(0, sigma²), with what differs between participants in sigma. "Not felt"
/// counts as the lowest term or less, "beyond practice" as the highest or more, if the participant also used a term.
/// Each threshold becomes a ramp of sqrt(3) sigma to both sides: the even distribution with the same mean and
/// deviation. It is at least half a usual step (ForceEnd) to both sides, because forces a step apart tell no more, and
/// narrower if a neighbor is nearer; the last one ends at the last counting step at the latest, or half a step above
/// its threshold. If the terms do not overlap in force, or fall while it rises, the thresholds are the midpoints of
/// termThresholds with half a step to both sides, and a note says so. A threshold without answers on one side, or
/// outside the judged forces, lies half a step outside them. Counting steps and the end of the universe: as in
/// `thresholdTerms`. `judgements` of `series`: those that `countVotes` counted into the `steps` of `vote`; none for a
/// table of counts. Returns the errors of `forceTerms`.
base::Result<ProbitTerms> probitTerms(const fuzzy::Variable& output, std::span<const study::ForceJudgement> judgements,
                                      std::string_view series, std::span<const VoteStep> steps,
                                      std::optional<double> end_n = std::nullopt);

/// The terms of `output` by the way `from`: forceTerms, frequencyTerms, thresholdTerms or probitTerms, with their
/// arguments and errors. `judgements` of `series` are those that `countVotes` counted into the `steps` of `vote`; only
/// kThresholds and kProbit look at them.
base::Result<ForceTerms> forceTermsFrom(ForceTermsFrom from, const fuzzy::Variable& output,
                                        std::span<const study::ForceJudgement> judgements, std::string_view series,
                                        std::span<const VoteStep> steps, std::optional<double> end_n = std::nullopt);

}  // namespace tactus::elicitation
