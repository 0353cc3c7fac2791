// How far one press of an arrow key moves a vertex.
#pragma once

#include "core/fuzzy/force_model.h"

namespace tactus::editing {

enum class StepSize { kFine, kCoarse };

/// Step in the unit of the variable, fine and coarse. mm and mm/s: 1 and 10; deg: 1 and 5; N: 0.01 and 0.05. Any other
/// unit: the round number (1, 2 or 5 times a power of ten) just below a hundredth and a tenth of the universe; for a
/// ratio 0.01 and 0.1.
double editStep(const fuzzy::Variable& variable, StepSize size);

/// `value` moved by `count` steps. A multiple of the step stays an exact multiple, without rounding errors.
double stepped(double value, double step, int count);

}  // namespace tactus::editing
