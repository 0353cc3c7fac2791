// The term that a value of a variable belongs to most.
#pragma once

#include <optional>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// Index of the term of `variable` with the largest membership at `x` (in its unit, taken as it is, also beyond the
/// universe), the first of equals; nothing where all memberships are 0.
std::optional<std::size_t> strongestTerm(const fuzzy::Variable& variable, double x);

}  // namespace tactus::analysis
