#include "core/render/printed_friction.h"

namespace tactus::render {

double printedStaticFriction(double stiffness_n_mm, double displacement_mm, double damping_n_s_mm,
                             double speed_mm_s) noexcept {
  return stiffness_n_mm * displacement_mm - damping_n_s_mm * speed_mm_s;
}

}  // namespace tactus::render
