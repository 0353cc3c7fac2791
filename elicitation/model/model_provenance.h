// The provenance of a built model.
#pragma once

#include <span>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

/// The choices of the method in `settings`, by name: `alpha`, `m`, … Those that are the same in every study.
std::vector<fuzzy::NamedJson> methodSettings(const BuildSettings& settings);

/// The settings of the build, with the forms and depth terms of each expert and BuildSettings::extra; the sizes of the
/// study's tables; and notes about simulated participants, if there are any.
fuzzy::Provenance modelProvenance(const study::Study& study, std::span<const ExpertRules> experts,
                                  const BuildSettings& settings);

}  // namespace tactus::elicitation
