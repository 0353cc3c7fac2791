// The servo's tick in a closed loop with the virtual device, tick by tick in simulated time.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/haptics/servo/sample.h"
#include "core/haptics/servo/servo_core.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::bench {

inline constexpr std::int64_t kFeelTickNs = 1'000'000;
inline constexpr double kFeelTickS = 0.001;

/// The model at the lubrication and the neck flexion of the benchmark; never refused for its cost.
std::shared_ptr<const haptics::ServoScene> feelScene(const fuzzy::ForceModel& model);

/// Insertion on `scene`, armed, with the default limits of the virtual device.
haptics::ServoOrders feelOrders(std::shared_ptr<const haptics::ServoScene> scene);

/// One tick, and what was true at it.
struct FeelTick {
  haptics::DeviceState device;
  haptics::Sample sample;
  double true_position_mm = 0;
  double true_speed_mm_s = 0;
};

struct FeelRun {
  std::vector<FeelTick> ticks;
  haptics::ServoCore core;  ///< as it was just before the tick `core_at`
};
/// `ticks` ticks from time 0.
FeelRun runFeelLoop(haptics::VirtualDeviceSettings settings, const haptics::ServoOrders& orders, int ticks,
                    int core_at = 0);

/// What the core is told at a tick that was recorded.
haptics::ServoTick told(const haptics::DeviceState& device, const haptics::ServoOrders& orders);

}  // namespace tactus::bench
