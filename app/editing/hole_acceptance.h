// Holes in the coverage that a researcher accepted: by name, so an acceptance holds for the boundaries that it was
// given for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editing/edit.h"

namespace tactus::editing {

// An edit that moves the boundary of an accepted hole does not take the acceptance along: the hole is another one, and
// the lint reports it until somebody accepts it too. The old name stays in the model, so a drag there and back leaves
// everything as it was; it goes when the new hole is accepted, when a fix closes the hole, or by forgetLapsed.

/// The names of all holes of `model`: of each expert and of the mean, as analysis::describe gives them, each once.
/// Nothing where the search was cut off, because then some are not known.
std::optional<std::vector<std::string>> holeNames(const fuzzy::ForceModel& model);

/// The acceptances that no hole has, in the order of the model. None where the search for holes was cut off.
std::vector<std::string> lapsedAcceptances(const fuzzy::ForceModel& model);

/// Adds the name of a hole to the accepted ones, in the place of those that lapsed; the force stays as it is. `name` as
/// analysis::describe gives it. Refused where it is accepted already.
base::Result<Edit> acceptHole(const fuzzy::ForceModel& model, const std::string& name);

/// The hole is a finding again. Refused where it is not accepted.
base::Result<Edit> withdrawAcceptance(const fuzzy::ForceModel& model, const std::string& name);

/// Removes the acceptances that lapsed. Refused where there are none.
base::Result<Edit> forgetLapsed(const fuzzy::ForceModel& model);

}  // namespace tactus::editing
