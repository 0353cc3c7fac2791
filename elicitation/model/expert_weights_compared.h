// The averaged model under each weight policy, and the differences of the forces.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/force_difference.h"
#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

/// One weight policy. Either `unavailable` says why the study's data do not allow it, or the other members are set.
struct WeightedModel {
  WeightPolicy policy = WeightPolicy::kEqual;
  std::string table;  ///< WeightSettings::table_file of a table
  std::string unavailable;
  std::optional<fuzzy::ForceModel> model;  ///< the averaged model with these weights
  analysis::ForceDifference from_equal;    ///< against equal weights
  std::string region;                      ///< term of the depth at the largest difference; empty if there is none
};

/// The model of `built` under every policy: equal, years, category, column, the table of `settings.weights` if there is
/// one, and each of `tables`. `study` and `settings`: as used for `built`. Nothing is clustered again.
base::Result<std::vector<WeightedModel>> compareWeights(const BuiltModel& built, const study::Study& study,
                                                        const BuildSettings& settings,
                                                        std::span<const WeightSettings> tables = {});

/// One table per expert, in which that expert counts twice. Shows the effect of weights for a study without data for
/// them.
std::vector<WeightSettings> eachCountsTwice(const BuiltModel& built);

}  // namespace tactus::elicitation
