// The term with the largest membership of a value.
#pragma once

#include <optional>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// The index of the term of `variable` with the largest membership at `x`; the first of equals. `x`: in the unit of the
/// variable, not clamped to the universe. Nothing if all memberships are 0.
std::optional<std::size_t> strongestTerm(const fuzzy::Variable& variable, double x);

}  // namespace tactus::analysis
