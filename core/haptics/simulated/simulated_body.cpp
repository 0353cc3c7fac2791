#include "core/haptics/simulated/simulated_body.h"

#include <algorithm>
#include <cmath>

namespace tactus::haptics {

std::span<const SimulatedHand> handPresets() noexcept {
  static constexpr SimulatedHand kPresets[] = {kNobody, kPinch, kArm, kFiveParameters};
  return kPresets;
}

const SimulatedHand* findHand(std::string_view name) noexcept {
  for (const SimulatedHand& hand : handPresets())
    if (hand.name == name) return &hand;
  return nullptr;
}

SimulatedBody::SimulatedBody(const SimulatedHand& hand, const DeviceMechanics& device, double position_mm,
                             double speed_mm_s) noexcept
    : hand_(hand),
      device_(device),
      x_(1e-3 * position_mm),
      v_(1e-3 * speed_mm_s),
      arm_x_(1e-3 * position_mm),
      arm_v_(1e-3 * speed_mm_s) {}

void SimulatedBody::step(const HandWish& wish, double resistance_n, double dt_s) noexcept {
  const double goal = 1e-3 * wish.position_mm;
  const double goal_speed = 1e-3 * wish.speed_mm_s;
  double hand_n = 0;
  if (hand_.arm_mass_kg > 0) {
    const double grip_n = wish.holds ? hand_.stiffness_n_m * (arm_x_ - x_) + hand_.damping_n_s_m * (arm_v_ - v_) : 0;
    const double arm_n = hand_.arm_stiffness_n_m * (goal - arm_x_) + hand_.arm_damping_n_s_m * (goal_speed - arm_v_);
    arm_v_ += dt_s * (arm_n - grip_n) / hand_.arm_mass_kg;
    arm_x_ += dt_s * arm_v_;
    hand_n = grip_n;
  } else if (wish.holds) {
    hand_n = hand_.stiffness_n_m * (goal - x_) + hand_.damping_n_s_m * (goal_speed - v_);
  }
  const double mass = device_.mass_kg + (wish.holds ? hand_.mass_kg : 0);
  v_ += dt_s * (hand_n - device_.damping_n_s_m * v_ - resistance_n) / mass;
  const double friction = std::min(std::abs(v_), dt_s * device_.dry_friction_n / mass);
  v_ -= std::copysign(friction, v_);
  x_ += dt_s * v_;
}

}  // namespace tactus::haptics
