#include "elicitation/force/noticeable_force.h"

#include <cmath>

namespace tactus::elicitation {

analysis::StepLimits forceStepLimits(const fuzzy::ForceModel& model) {
  analysis::StepLimits limits;
  limits.noticeable = justNoticeableDifference;
  limits.stiffness_n_mm = model.renderer.value_or(fuzzy::RendererParameters{}).stiffness_n_mm;
  return limits;
}

double justNoticeableDifference(double force_n) {
  constexpr double kThresholdN = 0.04;
  constexpr double kWeberFraction = 0.12;
  return std::hypot(kThresholdN, kWeberFraction * force_n);
}

}  // namespace tactus::elicitation
