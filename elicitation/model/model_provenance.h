// What a built model says of where it comes from.
#pragma once

#include <span>

#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

/// The settings of the build, with the forms and depth terms of each expert and BuildSettings::extra; the sizes of the
/// study's tables; and, where participants are marked as simulated, notes that say what of them is.
fuzzy::Provenance modelProvenance(const study::Study& study, std::span<const ExpertRules> experts,
                                  const BuildSettings& settings);

}  // namespace tactus::elicitation
