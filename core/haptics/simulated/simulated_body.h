// A hand on a one-axis haptic device, as masses, springs and dampers.
#pragma once

#include <span>
#include <string_view>

#include "core/haptics/simulated/hand_plan.h"

namespace tactus::haptics {

/// A hand: a mass on the device, tied to its wish by a spring and a damper. SI units, as published.
struct SimulatedHand {
  std::string_view name;
  double mass_kg = 0;  ///< moves with the device
  double damping_n_s_m = 0;
  double stiffness_n_m = 0;
  double arm_mass_kg = 0;  ///< > 0: an arm of this mass lies between, and the two numbers above describe its grip
  double arm_damping_n_s_m = 0;
  double arm_stiffness_n_m = 0;
};

inline constexpr SimulatedHand kNobody{"none"};
inline constexpr SimulatedHand kPinch{"pinch", 0.10, 1.5, 100};
inline constexpr SimulatedHand kArm{"arm", 0.55, 6.45, 135};  ///< van Beek 2016, one typical trial
/// Speich, Shao and Goldfarb 2005: grip and arm.
inline constexpr SimulatedHand kFiveParameters{"five-parameter", 0, 7.9, 375, 1.46, 4.5, 48.8};

/// All presets.
std::span<const SimulatedHand> handPresets() noexcept;
/// The preset of this name, or null.
const SimulatedHand* findHand(std::string_view name) noexcept;

/// The mechanics that the hand feels with the device switched off. Defaults: a Touch, at its tip.
struct DeviceMechanics {
  double mass_kg = 0.045;        ///< > 0
  double damping_n_s_m = 0.2;    ///< >= 0
  double dry_friction_n = 0.05;  ///< >= 0
};

/// Semi-implicit Euler. Dry friction is an impulse that can stop the motion but not reverse it. The error is of first
/// order in the step length (measured in docs/devices.md). Copyable, deterministic, without a clock.
class SimulatedBody {
 public:
  /// Device and arm start at `position_mm` with `speed_mm_s`.
  SimulatedBody(const SimulatedHand& hand, const DeviceMechanics& device, double position_mm = 0,
                double speed_mm_s = 0) noexcept;

  /// `wish` and `resistance_n` (positive against insertion) are constant for `dt_s` > 0. Steps of 10 us resolve all
  /// presets.
  /// Thread: any. Real-time safe: yes.
  void step(const HandWish& wish, double resistance_n, double dt_s) noexcept;

  double positionMm() const noexcept { return 1e3 * x_; }
  double speedMmS() const noexcept { return 1e3 * v_; }

 private:
  SimulatedHand hand_;
  DeviceMechanics device_;
  double x_, v_, arm_x_, arm_v_;  ///< m, m/s
};

}  // namespace tactus::haptics
