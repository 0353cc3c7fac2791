// A hand on a one-axis haptic device, simulated: what closes the loop around a friction model in tests.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace tactus::support {

/// A hand as a mass on the device, held by a spring and a damper to where it wants to be. SI units, as published.
struct Hand {
  const char* name;
  double mass_kg;  ///< moves with the device
  double damping_n_s_m;
  double stiffness_n_m;
  double arm_mass_kg = 0;  ///< > 0: an arm of this mass in between, and the two numbers above are its grip
  double arm_damping_n_s_m = 0;
  double arm_stiffness_n_m = 0;
};

inline constexpr Hand kNobody{"none", 0, 0, 0};
inline constexpr Hand kPinch{"pinch", 0.10, 1.5, 100};
inline constexpr Hand kArm{"arm", 0.55, 6.45, 135};  ///< van Beek 2016, one typical trial
/// Speich, Shao and Goldfarb 2005: grip and arm.
inline constexpr Hand kFiveParameters{"five-parameter", 0, 7.9, 375, 1.46, 4.5, 48.8};

struct Device {
  double mass_kg = 0.045;  ///< a Touch, seen at the tip
  double damping_n_s_m = 0.2;
  double dry_friction_n = 0.05;
  double count_mm = 0.055;  ///< positions are multiples of this
  int delay_ticks = 1;      ///< between a position and the force that answers it
};

/// What the hand wants at a time.
struct Wish {
  double position_mm = 0;
  double speed_mm_s = 0;
  bool holds = true;  ///< false: the hand has let go of the device
};
using Plan = std::function<Wish(double time_s)>;

Plan stroke(double length_mm, double duration_s);  ///< minimum jerk, then rest
Plan push(double speed_mm_s);
Plan tremor(double amplitude_mm, double frequency_hz);  ///< around 0
Plan both(Plan one, Plan other);
Plan lettingGo(Plan plan, double at_s);

/// The force for a measured position; positive resists motion to positive positions.
using Servo = std::function<double(double time_s, double position_mm, double dt_s)>;

struct Disturbance {
  double dropped_share = 0;  ///< of the ticks
  double stalls_per_s = 0;   ///< each of 2 to 5 ms
  std::uint64_t seed = 1;
};

struct LoopTick {
  double position_mm = 0;  ///< true, at the start of the tick
  double force_n = 0;      ///< held during the tick
};

/// Runs the loop at 1 kHz: semi-implicit Euler in steps of 10 microseconds, dry friction as a clipped impulse.
/// One entry per tick; deterministic.
std::vector<LoopTick> simulateLoop(const Hand& hand, const Device& device, const Plan& plan, double duration_s,
                                   const Servo& servo, const Disturbance& disturbance = {});

/// The lowest value of the energy that the force has taken from the hand so far, mJ. Below 0 the force has been active.
double lowestEnergyMj(const std::vector<LoopTick>& ticks);
double largestStepN(const std::vector<LoopTick>& ticks);
/// Root mean square of the force above 30 Hz (second-order Butterworth).
double rippleN(const std::vector<LoopTick>& ticks);
/// Root mean square of the speed during the last half second, mm/s.
double lastSpeedMmS(const std::vector<LoopTick>& ticks);

}  // namespace tactus::support
