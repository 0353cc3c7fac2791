// What closes a hole in the coverage: a term stretched over the gap, or the word of a researcher that it may stay.
#pragma once

#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/edit.h"
#include "core/analysis/coverage.h"

namespace tactus::editing {

/// Stretched terms that are offered for one hole: with many experts of own lists there could be hundreds.
inline constexpr std::size_t kMostStretches = 8;

/// The ways to settle `hole`, which coverage found in this very `model`, each with the text of its button: first those
/// that stretch a term, then acceptance (hole_acceptance.h), or taking it back. `expert`: whose hole it is; empty where
/// every expert abstains.
///
/// A term that a rule uses and that ends at the gap is stretched across it: its edge becomes the edge that faces it on
/// the other side, so the two sum to one there (a gap at the end of the universe is filled up to the end). Where the
/// list is shared and others read it too, an expert's hole is closed in a list of its own. Only edits after which no
/// part of the hole is left are offered; an edit that leaves a part of it would only move the finding. The acceptance
/// of a hole that nobody has any more goes with it. It ends soon after `stop` says so.
std::vector<std::pair<std::string, base::Result<Edit>>> closeHole(const fuzzy::ForceModel& model,
                                                                  const std::string& expert, const analysis::Hole& hole,
                                                                  const std::stop_token& stop = {});

}  // namespace tactus::editing
