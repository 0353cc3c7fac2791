// What closes a hole in the coverage: a term stretched over the gap, or the word of a researcher that it may stay.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/editing/edit.h"

namespace tactus::editing {

/// Adds the name of a hole to the model's accepted holes; the force stays as it is. `name` as analysis::describe gives
/// it. Refused where it is accepted already.
base::Result<Edit> acceptHole(const fuzzy::ForceModel& model, const std::string& name);

/// The ways to settle the hole called `name`, each with the text of its button: first those that stretch a term, then
/// acceptance. `expert`: whose hole it is; empty where every expert abstains.
///
/// A term that a rule uses and that ends at the gap is stretched across it: its edge becomes the edge that faces it on
/// the other side, so the two sum to one there (a gap at the end of the universe is filled up to the end). Where the
/// list is shared and others read it too, an expert's hole is closed in a list of its own. Only edits after which no
/// part of the hole is left are offered; an edit that leaves a part of it would only move the finding.
std::vector<std::pair<std::string, base::Result<Edit>>> closeHole(const fuzzy::ForceModel& model,
                                                                  const std::string& expert, const std::string& name);

}  // namespace tactus::editing
