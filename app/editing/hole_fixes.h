// The fixes of a coverage hole: stretch a term over the gap, or accept the hole.
#pragma once

#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/edit.h"
#include "core/analysis/coverage.h"

namespace tactus::editing {

/// The most stretched terms offered for one hole. Many experts with own lists could give hundreds.
inline constexpr std::size_t kMostStretches = 8;

/// The fixes of `hole`, which coverage found in this same `model`, each with the text of its button: first the
/// stretched terms, then acceptance (hole_acceptance.h) or its withdrawal. `expert`: the expert of the hole; empty if
/// every expert abstains.
///
/// A term that a rule uses and that ends at the gap is stretched: its edge becomes the facing edge on the other side,
/// so that the two sum to one there. (A gap at the end of the universe is filled to the end.) If other experts share
/// the list, the expert gets an own list. Only edits that close the whole hole are offered; an edit that leaves a part
/// would only move the finding. The edit also removes a lapsed acceptance of the hole. Returns soon after `stop` is
/// requested.
std::vector<std::pair<std::string, base::Result<Edit>>> closeHole(const fuzzy::ForceModel& model,
                                                                  const std::string& expert, const analysis::Hole& hole,
                                                                  const std::stop_token& stop = {});

}  // namespace tactus::editing
