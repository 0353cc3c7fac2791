// What an edit changed, by name: where the screen points to after a click on the edit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editing/term_list.h"
#include "core/fuzzy/force_model.h"

namespace tactus::editing {

struct ChangedParts {
  std::string expert;              ///< whose rules changed; empty if no rules did
  std::vector<std::size_t> rules;  ///< of that expert in the model after the edit, ascending; a removed rule has none
  std::optional<TermPlace> term;   ///< the first term with another shape or name, or a new one
};

/// The first expert with changed rules, and the first changed term. Both models are valid.
ChangedParts changedParts(const fuzzy::ForceModel& before, const fuzzy::ForceModel& after);

}  // namespace tactus::editing
