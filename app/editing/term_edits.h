// Adds, renames and removes terms.
#pragma once

#include <string>

#include "app/editing/term_list.h"

namespace tactus::editing {

/// An id that is free in the list, made from `wanted`: itself, or with the first free number appended.
std::string freeTermId(const std::vector<fuzzy::Term>& terms, const std::string& wanted);

/// A default term: a trapezoid around `at` with a core of 1/20 of the universe and ramps of the same width.
fuzzy::Term suggestedTerm(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, double at);

/// Inserts `term` before the first term whose core has its middle farther right. No rule names it yet. To make room in
/// a partition, split a term without copying its rules instead (splitTerm).
base::Result<Edit> addTerm(const fuzzy::ForceModel& model, const TermListId& list, const fuzzy::Term& term);

/// Gives a term another id and label. The rules that use the list are updated.
base::Result<Edit> renameTerm(const fuzzy::ForceModel& model, const TermPlace& place, const std::string& id,
                              const std::string& label);

struct RemoveOptions {
  RulesOfTerm rules = RulesOfTerm::kRefuse;
  /// The terms sum to one before and after. The neighbors meet in the middle of the removed core, with a ramp as wide
  /// as the mean of its two ramps. At an end of the universe the only neighbor takes its place.
  bool sum_to_one = false;
};

/// Removes a term. Refused: the last term of a list; with `sum_to_one`, terms that do not sum to one.
base::Result<Edit> removeTerm(const fuzzy::ForceModel& model, const TermPlace& place, const RemoveOptions& options);

}  // namespace tactus::editing
