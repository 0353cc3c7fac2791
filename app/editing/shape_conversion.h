// Converts a term to another shape.
#pragma once

#include "app/editing/term_list.h"

namespace tactus::editing {

/// The model with the converted term (analysis::convertedTerm). Terms that summed to one may no longer do so.
base::Result<Edit> convertShape(const fuzzy::ForceModel& model, const TermPlace& place, fuzzy::Shape shape);

}  // namespace tactus::editing
