// Settings of a virtual device: its mechanics, its hand, its delays, and its injected faults.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/device/vector3.h"
#include "core/haptics/simulated/hand_plan.h"
#include "core/haptics/simulated/simulated_body.h"

namespace tactus::haptics {

/// The faults that can be injected.
enum class InjectedFault : std::uint8_t {
  kUnplugged,   ///< the device reports kLost, and no force acts on the hand
  kStalled,     ///< no new samples, and no force reaches the device
  kStuckValue,  ///< samples continue, the position stays constant
  kNotANumber,  ///< samples continue, the position is NaN
  kWarmMotors,  ///< the device reports kWarmMotors but still gives the force
};

/// `unplugged`, `stalled`, `stuck_value`, `not_a_number`, `warm_motors`.
std::string_view name(InjectedFault fault) noexcept;
/// The fault of this name; empty for any other text.
std::optional<InjectedFault> faultNamed(std::string_view text) noexcept;

/// One fault in simulated time, to the millisecond.
struct FaultEvent {
  InjectedFault fault = InjectedFault::kStalled;
  double start_s = 0;
  double duration_s = std::numeric_limits<double>::infinity();
};

/// Defaults: a Touch, held in a pinch grip, on a fast bus.
struct VirtualDeviceSettings {
  DeviceMechanics mechanics;
  SimulatedHand hand = kPinch;
  HandPlan plan;  ///< empty: `setTarget` and `setButton` move the hand
  double start_mm = 0;

  double count_mm = 0.055;             ///< positions are multiples of this; 0: exact
  double delay_s = 0.001;              ///< [0, 0.1], between a position and the force that responds to it
  double dropped_share = 0;            ///< [0, 1]: share of the samples at 1 kHz that do not arrive
  double stalls_per_s = 0;             ///< [0, 1000]: rate of random InjectedFault::kStalled
  int shortest_stall_ms = 2;           ///< a stall lasts at least this long …
  int longest_stall_ms = 5;            ///< … and at most this long
  std::uint64_t seed = 1;              ///< of dropped samples and stalls
  std::vector<FaultEvent> faults;      ///< in any order; they may overlap
  double max_force_n = 3.3;            ///< > 0; a larger force is cut, and the device reports kForceLimited
  double continuous_force_n = 0.88;    ///< > 0; reported only, the motors do not warm up by themselves
  double quiet_after_s = 0.1;          ///< > 0: without a fresh force for this time the device gives none
  Vector3 inwards{0, 0, -1};           ///< unit length: direction of the axis in the device's frame
  int steps_per_ms = 100;              ///< [1, 1000], a divisor of 1000000
  double live_time_constant_s = 0.03;  ///< > 0: time constant with which a live hand follows its target
  double live_speed_mm_s = 250;  ///< > 0: largest speed of a live hand's wish; the pinch adds a third when it rings
};

/// Checks the settings, which may come from scenario files. Returns an error with the place `device: <member>` if a
/// value is out of range.
base::Result<void> check(const VirtualDeviceSettings& settings);

}  // namespace tactus::haptics
