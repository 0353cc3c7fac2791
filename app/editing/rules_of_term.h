// The rules of an expert that name a term: find, rename, remove.
#pragma once

#include <string>

#include "app/editing/term_list.h"

namespace tactus::editing {

/// Whether `rule` names the term: in a condition on an input, or as consequent if `variable` is the output.
bool names(const fuzzy::Rule& rule, const fuzzy::ForceModel& model, const fuzzy::Variable& variable,
           const std::string& term);

/// The rule with `to` in place of the term `from`.
fuzzy::Rule withTerm(fuzzy::Rule rule, const fuzzy::ForceModel& model, const fuzzy::Variable& variable,
                     const std::string& from, const std::string& to);

/// Removes the rules of `expert` that name the term, or refuses if there are any; `rules` chooses. `expert` and
/// `variable` are parts of `model`.
base::Result<void> letGo(fuzzy::Expert& expert, const fuzzy::ForceModel& model, const fuzzy::Variable& variable,
                         const std::string& term, RulesOfTerm rules);

}  // namespace tactus::editing
