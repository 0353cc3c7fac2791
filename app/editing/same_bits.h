// Compares parts of a model bit for bit. The operator == treats 0 and -0 as equal; these functions do not.
#pragma once

#include "core/fuzzy/force_model.h"

namespace tactus::editing {

bool sameBits(const fuzzy::Expert& one, const fuzzy::Expert& other);

/// The same for whole models. Undo guarantees it.
bool sameBits(const fuzzy::ForceModel& one, const fuzzy::ForceModel& other);

}  // namespace tactus::editing
