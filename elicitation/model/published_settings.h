// Which settings of a built model differ from the published method, and by how many newtons they move its force.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

/// The settings of `origin` that are not those of the paper, which are the defaults of BuildSettings: `alpha`, `m`, …
/// in the order of the file. Settings that the file does not name count as the paper's.
std::vector<std::string> settingsUnlikePublished(const fuzzy::Provenance& origin);

/// Where settings differ, adds to the origin of `built.model` the member `unlike_published` with their names and the
/// largest difference in N that was found between the averaged forces with them and with the published ones
/// (analysis::forceDifference); as many newtons as there are: a lower bound. `built`: from `study` with `settings`.
/// Does nothing where all are the paper's. Where no model can be built with those, the newtons are left out.
void noteUnlikePublished(BuiltModel& built, const study::Study& study, std::span<const study::Form> forms,
                         const BuildSettings& settings);

/// The newtons that `noteUnlikePublished` found; nothing if the file does not say.
std::optional<double> newtonsUnlikePublished(const fuzzy::Provenance& origin);

}  // namespace tactus::elicitation
