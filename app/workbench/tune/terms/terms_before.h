// The terms that a model had before an edit.
#pragma once

#include <vector>

#include "app/editing/term_list.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// The terms of `variable` in `model`, those of the expert where `list` is an expert's own; none where there is no such
/// list.
std::vector<fuzzy::Term> termsBefore(const fuzzy::ForceModel& model, const editing::TermListId& list,
                                     const fuzzy::Variable& variable);

}  // namespace tactus::workbench
