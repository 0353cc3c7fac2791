// The edits that give a wanted force, in words and as JSON.
#pragma once

#include <string>

#include "core/analysis/pull/pull.h"
#include "core/fuzzy/force_model.h"

namespace tactus::cli {

/// The edits of a candidate; for one that does not give the target also the force it gives. `model`: before the edits.
std::string candidateText(const fuzzy::ForceModel& model, const analysis::PullCandidate& candidate);

/// Why no single edit gives the target, as a clause: `beyond the nearest edit Laryngopharynx would have no core`.
std::string blockerText(const fuzzy::ForceModel& model, const analysis::Pull& pull);

/// What can be reached, the best edit of each kind (at most three) with its number, and how many more there are.
/// `rules_left_out`: the pull was of a mean.
std::string asText(const fuzzy::ForceModel& model, const analysis::Pull& pull, bool rules_left_out);

std::string asJson(const fuzzy::ForceModel& model, const analysis::Pull& pull);

}  // namespace tactus::cli
