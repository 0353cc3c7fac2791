#include "elicitation/force/force_step_limits.h"

#include "elicitation/force/noticeable_force.h"

namespace tactus::elicitation {

analysis::StepLimits forceStepLimits(const fuzzy::ForceModel& model) {
  analysis::StepLimits limits;
  limits.noticeable = justNoticeableDifference;
  limits.stiffness_n_mm = model.renderer.value_or(fuzzy::RendererParameters{}).stiffness_n_mm;
  return limits;
}

}  // namespace tactus::elicitation
