// What the commands print of the speeds of a study: levels, centres with intervals, and how far they agree.
#pragma once

#include <optional>
#include <string>

#include "core/base/json/json_writer.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/model/speed_bootstrap.h"

namespace tactus::cli {

/// The intervals of `built`'s speeds from `replicates` replicates. Nothing for no replicates or no speeds; where a
/// level has too few strokes nothing either, and a sentence in `note`.
std::optional<elicitation::StudySpeedIntervals> speedIntervals(const study::Study& study,
                                                               const elicitation::BuiltModel& built,
                                                               const elicitation::BuildSettings& settings,
                                                               std::size_t replicates, std::string& note);

/// A few lines for each participant with speeds, and one for the averaged ramps; empty without speeds.
std::string speedsAsText(const elicitation::BuiltModel& built,
                         const std::optional<elicitation::StudySpeedIntervals>& intervals);

/// The same as the member `speeds` of the object that `json` is in; `null` stands for what is absent.
void writeSpeeds(const elicitation::BuiltModel& built, const std::optional<elicitation::StudySpeedIntervals>& intervals,
                 base::JsonWriter& json);

}  // namespace tactus::cli
