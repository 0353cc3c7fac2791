// Parameters of the exact reference and slots of the gradient: the same numbers by two names.
#pragma once

#include "core/analysis/gradient/gradient.h"

#include "tests/reference/exact_gradient.h"

namespace tactus::support {

inline std::size_t slotOf(const analysis::GradientModel& model, const reference::Parameter& p) {
  switch (p.kind) {
    case reference::Parameter::Kind::kInput:
      return model.inputSlot(p.variable);
    case reference::Parameter::Kind::kWeight:
      return model.weightSlot(*p.expert, p.index);
    case reference::Parameter::Kind::kPoint:
      break;
  }
  return p.expert ? model.pointSlot(*p.expert, p.variable, p.index, p.point)
                  : model.pointSlot(p.variable, p.index, p.point);
}

}  // namespace tactus::support
