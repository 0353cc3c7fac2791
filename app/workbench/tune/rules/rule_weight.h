// The box to type the weight of a rule.
#pragma once

#include "app/workbench/kit/number_box.h"

namespace tactus::workbench {

/// A number in [0, 1], in steps of 0.05.
NumberBox* makeWeightBox(QWidget* parent);

}  // namespace tactus::workbench
