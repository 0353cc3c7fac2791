// The third way from judgements to the terms of the force: the mean of each participant's thresholds.
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

/// Where one participant's terms end, in N: one number between each two terms, ascending or equal.
struct ForceThresholds {
  std::string participant;
  std::vector<double> threshold_n;
  int outside = 0;  ///< how many of them lie half a step outside the forces that the participant judged
};

struct ThresholdTerms : ForceTerms {
  std::vector<ForceThresholds> participants;  ///< who gave at least one term, in the order of the judgements
  std::vector<double> mean_n;                 ///< of their thresholds
};

/// Each judged force stands for the forces nearer to it than to another one; the lowest and the highest for half a
/// usual step (ForceEnd) beyond. A participant's threshold above term k lies where the judged stretch begins plus the
/// width of all stretches with term k or below (Spearman 1908, Karber 1931), so forces that were judged out of order
/// cancel. "Not felt" is below all terms, "beyond practice" above all; missing answers are no stretch. The thresholds
/// are averaged over the participants, each counting once, and each mean becomes a ramp of half a step to both sides,
/// narrower where a neighbour is nearer than a step. Equal means share that width: terms between them that nobody used
/// are narrow triangles.
/// Which steps count: as for `forceTerms`. The universe ends at the last of them, or where the last ramp ends if that
/// is higher; at `end_n` where that is given. `judgements` of one `series` are those that `countVotes` counted into the
/// `steps` of `vote`. Refused: as by `forceTerms`.
base::Result<ThresholdTerms> thresholdTerms(const fuzzy::Variable& output,
                                            std::span<const study::ForceJudgement> judgements, std::string_view series,
                                            std::span<const VoteStep> steps,
                                            std::optional<double> end_n = std::nullopt);

}  // namespace tactus::elicitation
