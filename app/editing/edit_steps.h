// How far one press of an arrow key moves a vertex.
#pragma once

#include "core/fuzzy/force_model.h"

namespace tactus::editing {

enum class StepSize { kFine, kCoarse };

/// Step in the unit of the variable. mm and mm/s: 1 and 10; deg: 1 and 5; N: 0.01 and 0.05; any other unit: the round
/// number (1, 2 or 5 times a power of ten) next below a hundredth and a tenth of the universe, so 0.01 and 0.1 for a
/// ratio.
double editStep(const fuzzy::Variable& variable, StepSize size);

/// `value` moved by `count` steps. A value on the grid of steps stays on it exactly, whatever the rounding.
double stepped(double value, double step, int count);

}  // namespace tactus::editing
