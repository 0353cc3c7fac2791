// What a virtual device is made of: its mechanics, its hand, its delays, and what goes wrong with it and when.
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

/// What can be made to go wrong.
enum class InjectedFault : std::uint8_t {
  kUnplugged,   ///< the device reports kLost, and nothing pulls at the hand
  kStalled,     ///< no new samples, and no force reaches the device
  kStuckValue,  ///< samples go on, the position stays what it was
  kNotANumber,  ///< samples go on, the position is NaN
  kWarmMotors,  ///< the device reports kWarmMotors and does what it is told all the same
};

/// `unplugged`, `stalled`, `stuck_value`, `not_a_number`, `warm_motors`.
std::string_view name(InjectedFault fault) noexcept;
/// Nothing for another text.
std::optional<InjectedFault> faultNamed(std::string_view text) noexcept;

/// One fault in simulated time, to the millisecond.
struct FaultEvent {
  InjectedFault fault = InjectedFault::kStalled;
  double start_s = 0;
  double duration_s = std::numeric_limits<double>::infinity();
};

/// The defaults are a Touch in the pinch of a hand, on a fast bus.
struct VirtualDeviceSettings {
  DeviceMechanics mechanics;
  SimulatedHand hand = kPinch;
  HandPlan plan;  ///< empty: the hand is driven live by `setTarget` and `setButton`
  double start_mm = 0;

  double count_mm = 0.055;             ///< positions are multiples of this; 0: exact
  double delay_s = 0.001;              ///< [0, 0.1], between a position and the force that answers it
  double dropped_share = 0;            ///< [0, 1]: samples that do not arrive, of those at 1 kHz
  double stalls_per_s = 0;             ///< [0, 1000]: chance of an InjectedFault::kStalled
  int shortest_stall_ms = 2;           ///< a stall lasts as long or longer, …
  int longest_stall_ms = 5;            ///< … and this at most
  std::uint64_t seed = 1;              ///< of dropped samples and stalls
  std::vector<FaultEvent> faults;      ///< any order; they may overlap
  double max_force_n = 3.3;            ///< > 0; larger is cut, and the device reports kForceLimited
  double continuous_force_n = 0.88;    ///< > 0; only told, motors do not get warm by themselves
  double quiet_after_s = 0.1;          ///< > 0: without a fresh force for so long it gives none
  Vector3 inwards{0, 0, -1};           ///< unit length: where the axis lies in the device's frame
  int steps_per_ms = 100;              ///< [1, 1000], a divisor of 1000000
  double live_time_constant_s = 0.03;  ///< > 0: how fast a live hand follows its target
  double live_speed_mm_s = 250;        ///< > 0: largest speed of its wish; the pinch adds a third when it rings
};

/// Nothing, or what is out of range: settings come from scenario files too. The place is `device: <member>`.
base::Result<void> check(const VirtualDeviceSettings& settings);

}  // namespace tactus::haptics
