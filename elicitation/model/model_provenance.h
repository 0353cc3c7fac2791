// The provenance of a built model.
#pragma once

#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

// The reference evaluations stored in a model.

/// Replaces the checks of `model` by at most 120 points with their forces, chosen so that the ordinary mistakes of a
/// program that reads the file show (core/analysis/check_points.h). Returns the error of `fuzzy::validate`.
base::Result<void> setChecks(fuzzy::ForceModel& model);

/// The choices of the method in `settings`, by name: `alpha`, `m`, … Those that are the same in every study.
std::vector<fuzzy::NamedJson> methodSettings(const BuildSettings& settings);

/// The settings of the build, with the forms and depth terms of each expert and BuildSettings::extra; the sizes of the
/// study's tables; and notes about simulated participants, if there are any.
fuzzy::Provenance modelProvenance(const study::Study& study, std::span<const ExpertRules> experts,
                                  const BuildSettings& settings);

}  // namespace tactus::elicitation
