// Whether two parts of a model are the same bit for bit: unlike ==, which takes 0 and -0 for equal.
#pragma once

#include "core/fuzzy/force_model.h"

namespace tactus::editing {

bool sameBits(const fuzzy::Expert& one, const fuzzy::Expert& other);

/// The same of whole models: undo promises this.
bool sameBits(const fuzzy::ForceModel& one, const fuzzy::ForceModel& other);

}  // namespace tactus::editing
