// The terms of the force by any of the ways that lead from the judgements to them.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/force/force_terms.h"
#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {

/// The terms of `output` by the way `from`: forceTerms, frequencyTerms, thresholdTerms or probitTerms, with their
/// arguments and errors. `judgements` of `series` are those that `countVotes` counted into the `steps` of `vote`; only
/// kThresholds and kProbit look at them.
base::Result<ForceTerms> forceTermsFrom(ForceTermsFrom from, const fuzzy::Variable& output,
                                        std::span<const study::ForceJudgement> judgements, std::string_view series,
                                        std::span<const VoteStep> steps, std::optional<double> end_n = std::nullopt);

}  // namespace tactus::elicitation
