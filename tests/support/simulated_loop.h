// A force calculation in a loop with the virtual device, tick by tick, with ticks that are missed.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/haptics/simulated/virtual_device.h"

namespace tactus::support {

/// The force for a measured position; positive resists motion to positive positions.
using Servo = std::function<double(double time_s, double position_mm, double dt_s)>;

/// What goes wrong in the servo; for faults of the device see VirtualDeviceSettings.
struct Disturbance {
  double dropped_share = 0;  ///< of the ticks
  double stalls_per_s = 0;   ///< each of 2 to 5 ms
  std::uint64_t seed = 1;
};

struct LoopTick {
  double position_mm = 0;  ///< true, at the start of the tick
  double force_n = 0;      ///< held during the tick
};

/// Runs the loop at 1 kHz on a virtual device with the hand and plan given. One entry per tick; deterministic.
std::vector<LoopTick> simulateLoop(const haptics::SimulatedHand& hand, haptics::VirtualDeviceSettings device,
                                   const haptics::HandPlan& plan, double duration_s, const Servo& servo,
                                   const Disturbance& disturbance = {});

}  // namespace tactus::support
