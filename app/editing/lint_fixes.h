// The fixes of a lint finding: edits that settle it with one click, each with its effect in newtons.
#pragma once

#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/edit.h"
#include "app/editing/edit_impact.h"
#include "core/analysis/coverage.h"
#include "core/analysis/lint.h"

namespace tactus::editing {

// The fixes of a coverage hole: stretch a term over the gap, or accept the hole.

/// The most stretched terms offered for one hole. Many experts with own lists could give hundreds.
inline constexpr std::size_t kMostStretches = 8;

/// The fixes of `hole`, which coverage found in this same `model`, each with the text of its button: first the
/// stretched terms, then acceptance (step_fixes.h) or its withdrawal. `expert`: the expert of the hole; empty if
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

struct Fix {
  std::string text;   ///< text of the button: `Stretch Laryngopharynx over the gap`
  Edit edit;          ///< for EditHistory::apply
  EditImpact impact;  ///< effect of the edit on the averaged force
};

/// The fixes of `finding`, found in this same `model` (valid; `compiled` is made from it). Empty if only a person can
/// decide. The function decides nothing: the researcher chooses a fix, ideally together with the expert.
///   hole                stretch the term of either side over the gap, or accept the hole (lint_fixes.h); for an
///                       accepted hole: stretch, or withdraw the acceptance
///   abstention jump     the fixes of the expert's hole behind it
///   force step          widen the flanks at the step (step_fixes.h)
///   conflict            disable one of the two rules, or the other
///   redundant rule, unreachable rule    disable it
///   unused or unreachable term          remove it; if the terms sum to one, also with the neighbors closing the gap
///   region without a rule               the same for its term, and the fixes of the hole that it leaves
/// Returns soon after `stop` is requested; the result is then incomplete and must not be used.
std::vector<Fix> fixesFor(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                          const analysis::Finding& finding, const std::stop_token& stop = {});

}  // namespace tactus::editing
