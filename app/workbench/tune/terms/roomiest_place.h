// Where a new term has the most room.
#pragma once

#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// The middle of the widest gap between `terms` of `variable`; without gaps, the middle of the right half of the widest
/// core. In the unit of the variable.
double roomiestPlace(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms);

}  // namespace tactus::workbench
