// The speeds of a study in the output of the commands: levels, centers with intervals, and their agreement.
#pragma once

#include <optional>
#include <string>

#include "core/base/json/json_writer.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/model/speed_bootstrap.h"

namespace tactus::cli {

/// The intervals of the speeds in `built` from `replicates` bootstrap replicates. Nothing if there are no replicates or
/// no speeds. Nothing, with a sentence in `note`, if a level has too few strokes.
std::optional<elicitation::StudySpeedIntervals> speedIntervals(const study::Study& study,
                                                               const elicitation::BuiltModel& built,
                                                               const elicitation::BuildSettings& settings,
                                                               std::size_t replicates, std::string& note);

/// A few lines for each participant with speeds, and one line for the averaged ramps; empty without speeds.
std::string speedsAsText(const elicitation::BuiltModel& built,
                         const std::optional<elicitation::StudySpeedIntervals>& intervals);

/// The same as the member `speeds` of the open object of `json`; absent values are `null`.
void writeSpeeds(const elicitation::BuiltModel& built, const std::optional<elicitation::StudySpeedIntervals>& intervals,
                 base::JsonWriter& json);

}  // namespace tactus::cli
