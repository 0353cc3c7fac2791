// The model of a study again, with other settings, to be compared with the one that there is.
#pragma once

#include <span>

#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

/// Where the speeds of another build come from.
enum class SpeedsOf {
  kBuilt,  ///< the clusters of `built`: of BuildSettings::speed only alpha is another
  kStudy,  ///< clustered again
};

/// The model of buildModel for other settings, without what leaving out an expert changes: many of them are compared
/// with `built`, which is from the same study.
base::Result<fuzzy::ForceModel> rebuiltModel(const BuiltModel& built, const study::Study& study,
                                             std::span<const study::Form> forms, const BuildSettings& settings,
                                             SpeedsOf speeds);

}  // namespace tactus::elicitation
