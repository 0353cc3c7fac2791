// Force terms by thresholds: the mean of each participant's thresholds.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/force/force_terms.h"
#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {

/// The ends of one participant's terms, in N: one number between two terms, ascending or equal.
struct ForceThresholds {
  std::string participant;
  std::vector<double> threshold_n;
  int outside = 0;  ///< number of thresholds half a step outside the forces that the participant judged
};

struct ThresholdTerms : ForceTerms {
  std::vector<ForceThresholds> participants;  ///< those with at least one term, in the order of the judgements
  std::vector<double> mean_n;                 ///< of their thresholds
};

/// Each judged force represents the forces nearer to it than to any other one; the lowest and the highest reach half a
/// usual step (ForceEnd) further. A participant's threshold above term k is the start of the judged range plus the
/// width of all parts with term k or below (Spearman 1908, Karber 1931). So forces judged out of order cancel. "Not
/// felt" is below all terms, "beyond practice" above all; missing answers have no width.
/// The thresholds are averaged over the participants, with equal weight. Each mean becomes a ramp of half a step to
/// both sides, narrower if a neighbor is nearer than a step. Equal means share that width; unused terms between them
/// become narrow triangles.
/// Counting steps: as in `forceTerms`. The universe ends at `end_n` if given; otherwise at the last counting step or
/// the end of the last ramp, whichever is higher. `judgements` of `series`: those that `countVotes` counted into the
/// `steps` of `vote`. Returns the errors of `forceTerms`.
base::Result<ThresholdTerms> thresholdTerms(const fuzzy::Variable& output,
                                            std::span<const study::ForceJudgement> judgements, std::string_view series,
                                            std::span<const VoteStep> steps,
                                            std::optional<double> end_n = std::nullopt);

}  // namespace tactus::elicitation
