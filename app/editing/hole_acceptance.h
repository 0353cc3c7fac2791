// Acceptance of coverage holes by a researcher. An acceptance is a hole's name with its boundaries, so it holds for
// these boundaries only:
//   accepted: the hole at depth 125 to 138 mm
//   after an edit moves it to 125 to 140 mm: a new hole, reported by the lint; the acceptance has lapsed
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editing/edit.h"

namespace tactus::editing {

// A lapsed acceptance stays in the model, so that a drag there and back changes nothing. It is removed when the new
// hole is accepted, when a fix closes the hole, or by forgetLapsed.

/// The names of all holes of `model`, of each expert and of the mean, as analysis::describe gives them; each once.
/// Nothing if the search was cut off, because then some holes are unknown.
std::optional<std::vector<std::string>> holeNames(const fuzzy::ForceModel& model);

/// The acceptances without a hole, in the order of the model. Empty if the search for holes was cut off.
std::vector<std::string> lapsedAcceptances(const fuzzy::ForceModel& model);

/// Adds a hole's name to the accepted ones and removes all lapsed acceptances. The force does not change. `name`: as
/// analysis::describe gives it. Refused if it is accepted already.
base::Result<Edit> acceptHole(const fuzzy::ForceModel& model, const std::string& name);

/// Makes the hole a finding again. Refused if it is not accepted.
base::Result<Edit> withdrawAcceptance(const fuzzy::ForceModel& model, const std::string& name);

/// Removes the lapsed acceptances. Refused if there are none.
base::Result<Edit> forgetLapsed(const fuzzy::ForceModel& model);

}  // namespace tactus::editing
