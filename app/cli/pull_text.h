// The edits that give a wanted force, in words and as JSON.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/pull_sign_offs.h"
#include "core/analysis/pull/pull.h"
#include "core/base/json/json_writer.h"
#include "core/fuzzy/force_model.h"

namespace tactus::cli {

/// What the lint newly finds in the model after a candidate, one sentence each.
using FindingsAfter = std::function<std::vector<std::string>(const analysis::PullCandidate&)>;

/// What is said besides the edits.
struct PullNotes {
  FindingsAfter findings;
  std::vector<SignOff> sign_offs;  ///< on the model as it is; every edit contradicts them
};

/// The member `sign_offs`.
void writeSignOffs(base::JsonWriter& json, const std::vector<SignOff>& sign_offs);

/// The edits of a candidate; for one that does not give the target also the force it gives, and the experts whose
/// answers it contradicts. `model`: before the edits.
std::string candidateText(const fuzzy::ForceModel& model, const analysis::PullCandidate& candidate);

/// Why no single edit gives the target, as a clause: `beyond the nearest edit Laryngopharynx would have no core`.
std::string blockerText(const fuzzy::ForceModel& model, const analysis::Pull& pull);

/// What can be reached, the best edit of each kind (at most three) with its number, and how many more there are.
/// `rules_left_out`: the pull was of a mean.
std::string asText(const fuzzy::ForceModel& model, const analysis::Pull& pull, bool rules_left_out,
                   const PullNotes& notes);

std::string asJson(const fuzzy::ForceModel& model, const analysis::Pull& pull, const PullNotes& notes);

}  // namespace tactus::cli
