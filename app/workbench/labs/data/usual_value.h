// Where curves are drawn before anybody chooses a place.
#pragma once

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// The value of `input` in the paper's Fig. 11; the middle of any other input.
double usualValue(const fuzzy::Variable& input);

}  // namespace tactus::workbench
