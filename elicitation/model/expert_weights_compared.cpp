#include "elicitation/model/expert_weights_compared.h"

#include <utility>

#include "core/analysis/term_conversion.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::elicitation {
namespace {

using base::Result;

/// The model with these weights, or the error that says what the data lack.
Result<fuzzy::ForceModel> under(WeightSettings weights, const BuiltModel& built, const study::Study& study,
                                BuildSettings settings) {
  settings.weights = std::move(weights);
  return reweightedModel(built, study, settings);
}

/// `settings` with another policy.
WeightSettings with(WeightPolicy policy, WeightSettings settings) {
  settings.policy = policy;
  return settings;
}

/// The term of the way with the largest membership at `point`; empty where there is no point.
std::string regionAt(const fuzzy::ForceModel& model, const std::vector<double>& point) {
  const auto way = fuzzy::wayOf(model.inputs);
  if (!way || *way >= point.size()) return {};
  const auto term = analysis::strongestTerm(model.inputs[*way], point[*way]);
  return term ? model.inputs[*way].terms[*term].id : std::string();
}

}  // namespace

Result<std::vector<WeightedModel>> compareWeights(const BuiltModel& built, const study::Study& study,
                                                  const BuildSettings& settings,
                                                  std::span<const WeightSettings> tables) {
  TACTUS_TRY(const auto equal, under(with(WeightPolicy::kEqual, settings.weights), built, study, settings));
  TACTUS_TRY(const auto compiled_equal, fuzzy::compile(equal));

  std::vector<WeightSettings> all;
  for (const auto policy :
       {WeightPolicy::kEqual, WeightPolicy::kYears, WeightPolicy::kCategory, WeightPolicy::kColumn}) {
    all.push_back(with(policy, settings.weights));
  }
  if (!settings.weights.table.empty()) all.push_back(with(WeightPolicy::kTable, settings.weights));
  all.insert(all.end(), tables.begin(), tables.end());

  std::vector<WeightedModel> out;
  for (const auto& weights : all) {
    auto& one = out.emplace_back();
    one.policy = weights.policy;
    if (weights.policy == WeightPolicy::kTable) one.table = weights.table_file;
    auto model = under(weights, built, study, settings);
    if (!model) {
      one.unavailable = model.error().message();
      continue;
    }
    TACTUS_TRY(const auto compiled, fuzzy::compile(*model));
    one.from_equal = analysis::forceDifference(equal, compiled_equal, *model, compiled);
    one.region = regionAt(equal, one.from_equal.at);
    one.model = std::move(*model);
  }
  return out;
}

std::vector<WeightSettings> eachCountsTwice(const BuiltModel& built) {
  std::vector<WeightSettings> out;
  for (const auto& twice : built.experts) {
    WeightSettings weights;
    weights.policy = WeightPolicy::kTable;
    weights.table_file = twice.participant.code + " counts twice";
    for (const auto& expert : built.experts) weights.table[expert.participant.code] = 1;
    weights.table[twice.participant.code] = 2;
    out.push_back(std::move(weights));
  }
  return out;
}

}  // namespace tactus::elicitation
