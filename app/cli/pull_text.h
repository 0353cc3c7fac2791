// The edits that give a wanted force, in words and as JSON.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/analysis/pull/pull_text.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/fuzzy/force_model.h"
#include "core/model_io/bundle_check.h"

namespace tactus::cli {

using analysis::blockerText;
using analysis::candidateText;
using analysis::contradicted;
using analysis::elsewhereText;
using analysis::gapOf;

/// Who signed off a model, so that an edit of it contradicts them.
using SignOff = model_io::Approval;

/// The sign-offs in the history of the study file `path` on a state with the terms, rules and settings of `model`, from
/// the oldest. When it was written, by which program, its provenance and checks do not count.
base::Result<std::vector<SignOff>> signOffsOn(fuzzy::ForceModel model, const std::string& path);

// The edits that a pull offers, in words and as members of JSON.

/// A line for each new finding of the lint, as below a candidate.
std::string findingsText(const std::vector<std::string>& findings);

/// Writes the members `kind` to `new_findings` of a candidate; edits after the first are objects in `more`.
void writeMembers(base::JsonWriter& json, const fuzzy::ForceModel& model, const analysis::PullCandidate& candidate,
                  const std::vector<std::string>& findings);

/// What the lint newly finds in the model after a candidate, one sentence each.
using FindingsAfter = std::function<std::vector<std::string>(const analysis::PullCandidate&)>;

/// What is said besides the edits.
struct PullNotes {
  FindingsAfter findings;
  std::vector<SignOff> sign_offs;  ///< on the model as it is; every edit contradicts them
};

/// The member `sign_offs`.
void writeSignOffs(base::JsonWriter& json, const std::vector<SignOff>& sign_offs);

/// What can be reached, the best edit of each kind (at most three) with its number, and how many more there are.
/// `rules_left_out`: the pull was of a mean.
std::string asText(const fuzzy::ForceModel& model, const analysis::Pull& pull, bool rules_left_out,
                   const PullNotes& notes);

std::string asJson(const fuzzy::ForceModel& model, const analysis::Pull& pull, const PullNotes& notes);

}  // namespace tactus::cli
