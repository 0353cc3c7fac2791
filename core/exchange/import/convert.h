// From the model of another program to a force model of one expert.
#pragma once

#include <string>

#include "core/exchange/import/foreign_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::exchange {

/// The valid ForceModel with the forces of `foreign`, or one sentence: what Tactus cannot carry, with its place. OR and
/// NOT are split into rules and terms, exactly. What changes no force becomes a warning of the source. `output`: the
/// name of the output to take where there are several; may be empty.
base::Result<fuzzy::ForceModel> converted(const ForeignModel& foreign, const std::string& output);

}  // namespace tactus::exchange
