// Terms added, renamed, removed.
#pragma once

#include <string>

#include "app/editing/term_list.h"

namespace tactus::editing {

/// An id that no term of the list has, made from `wanted`: itself, or with the first free number behind it.
std::string freeTermId(const std::vector<fuzzy::Term>& terms, const std::string& wanted);

/// A term to begin with: a trapezoid around `at` with a core of a twentieth of the universe and ramps as wide.
fuzzy::Term suggestedTerm(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, double at);

/// Adds `term` before the first term whose core has its middle farther right. No rule mentions it yet. To make room in
/// terms that sum to one, split one without copying its rules (splitTerm).
base::Result<Edit> addTerm(const fuzzy::ForceModel& model, const TermListId& list, const fuzzy::Term& term);

/// Gives a term another id and label. The rules that resolve against the list follow.
base::Result<Edit> renameTerm(const fuzzy::ForceModel& model, const TermPlace& place, const std::string& id,
                              const std::string& label);

struct RemoveOptions {
  RulesOfTerm rules = RulesOfTerm::kRefuse;
  /// The terms sum to one before and after: the neighbours meet in the middle of the removed core, with a ramp as wide
  /// as the mean of its two; at an end of the universe the one neighbour takes its place.
  bool sum_to_one = false;
};

/// Removes a term. Refused: the last one of a list; terms that do not sum to one where they should.
base::Result<Edit> removeTerm(const fuzzy::ForceModel& model, const TermPlace& place, const RemoveOptions& options);

}  // namespace tactus::editing
