// The generalised model with each way to weight the experts, and how far the forces differ.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/force_difference.h"
#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

/// One way to weight. Either `unavailable` says why the study's data do not allow it, or the rest is filled in.
struct WeightedModel {
  WeightPolicy policy = WeightPolicy::kEqual;
  std::string table;  ///< WeightSettings::table_file of a table
  std::string unavailable;
  std::optional<fuzzy::ForceModel> model;  ///< the averaged model with these weights
  analysis::ForceDifference from_equal;    ///< against equal weights
  std::string region;  ///< term of the depth where the difference is largest; empty where there is none
};

/// The model of `built` under every policy: equal, years, category, column, the table where `settings.weights` has one,
/// and each of `tables`. `study` and `settings` as `built` was made from. Nothing is clustered again.
base::Result<std::vector<WeightedModel>> compareWeights(const BuiltModel& built, const study::Study& study,
                                                        const BuildSettings& settings,
                                                        std::span<const WeightSettings> tables = {});

/// One table for each expert, in which that expert counts twice and the others once: what weights would do where a
/// study has no numbers for them.
std::vector<WeightSettings> eachCountsTwice(const BuiltModel& built);

}  // namespace tactus::elicitation
