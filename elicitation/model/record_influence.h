// What one record moves: the averaged force with and without a judgement, a rule or a stroke, in newtons.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/analysis/force_difference.h"
#include "core/base/error.h"
#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

// The model of a study again, with other settings, to be compared with the one that there is.

/// Where the speeds of another build come from.
enum class SpeedsOf {
  kBuilt,  ///< the clusters of `built`: of BuildSettings::speed only alpha is another
  kStudy,  ///< clustered again
};

/// The model of buildModel for other settings, without what leaving out an expert changes and without checks: many of
/// them are compared with `built`, which is from the same study.
base::Result<fuzzy::ForceModel> rebuiltModel(const BuiltModel& built, const study::Study& study,
                                             std::span<const study::Form> forms, const BuildSettings& settings,
                                             SpeedsOf speeds);

struct RecordInfluence {
  analysis::ForceDifference difference;  ///< `first_n` with the record, `second_n` without it
  double noticeable = 0;                 ///< the largest difference in just-noticeable differences around `first_n`
};

/// Without judgement `index` of `study`: the vote and the words of the force are made again, everything else of `built`
/// stays. `study`, `settings`: as used for `built`. A judgement of another series moves nothing. Refused: a judgement
/// without which the words cannot be made, or without which a word of a rule is missing. Thread: any.
base::Result<RecordInfluence> withoutJudgement(const BuiltModel& built, const study::Study& study,
                                               const BuildSettings& settings, std::size_t index);

/// Without rule `rule` of the expert number `expert`. Without its only rule an expert abstains. Thread: any.
base::Result<RecordInfluence> withoutRule(const BuiltModel& built, std::size_t expert, std::size_t rule);

/// Without one stroke: the speeds of its participant are clustered again and averaged with those of the others,
/// everything else of `built` stays. `study`, `settings`: as used for `built`. Refused: a stroke that is not there, the
/// last one of all participants, and what is left of the participant's speeds not making terms. Thread: any.
base::Result<RecordInfluence> withoutStroke(const BuiltModel& built, const study::Study& study,
                                            const BuildSettings& settings, std::string_view participant,
                                            std::string_view level, int stroke);

// What the rules of many experts move, one rule of each: the averaged force with and without it.

/// For each expert of `built` what leaving out its rule `rules[expert]` moves, as `withoutRule` does one by one: at the
/// same points, and the forces agree but for rounding. The forces of the other experts are computed once for all, so
/// that hundreds of experts take seconds. Nothing where an expert has no rule to leave out. Incomplete after a stop
/// request. Thread: any.
std::vector<std::optional<RecordInfluence>> withoutRules(const BuiltModel& built,
                                                         std::span<const std::optional<std::size_t>> rules,
                                                         const std::stop_token& stop = {});

}  // namespace tactus::elicitation
