// The edits that a pull offers, in words and as members of JSON.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/analysis/pull/pull.h"
#include "core/base/json/json_writer.h"
#include "core/fuzzy/force_model.h"

namespace tactus::cli {

/// `Depth, Laryngopharynx/Esophagus: the transition ends at 202.107 instead of 215.000 mm`. `model`: before the edit.
std::string editText(const fuzzy::ForceModel& model, const analysis::PullEdit& edit);

/// Several edits, made one after the other. `model`: before all of them.
std::string editsText(const fuzzy::ForceModel& model, std::span<const analysis::PullEdit> edits);

/// `elsewhere it moves the force by 0.090 just-noticeable differences, at most 0.159 N`.
std::string elsewhereText(const analysis::PullCandidate& candidate);

/// `; contradicts S4's answer` where an edit gives a rule another word or takes it away; otherwise nothing.
std::string contradictionText(const analysis::PullCandidate& candidate);

/// A line for each new finding of the lint, as below a candidate.
std::string findingsText(const std::vector<std::string>& findings);

/// Writes the members `kind` to `new_findings` of a candidate; edits after the first are objects in `more`.
void writeMembers(base::JsonWriter& json, const fuzzy::ForceModel& model, const analysis::PullCandidate& candidate,
                  const std::vector<std::string>& findings);

}  // namespace tactus::cli
