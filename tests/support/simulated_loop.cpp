#include "tests/support/simulated_loop.h"

#include <cmath>
#include <utility>

#include "core/base/check.h"
#include "core/base/random.h"
#include "core/haptics/device/device.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::support {

std::vector<LoopTick> simulateLoop(const haptics::SimulatedHand& hand, haptics::VirtualDeviceSettings device,
                                   const haptics::HandPlan& plan, double duration_s, const Servo& servo,
                                   const Disturbance& disturbance) {
  constexpr double kTickS = 0.001;
  constexpr std::int64_t kTickNs = 1'000'000;
  device.hand = hand;
  device.plan = plan;
  const auto made = haptics::VirtualDevice::make(std::move(device));
  TACTUS_CHECK(made.has_value());
  haptics::VirtualDevice& simulated = **made;
  TACTUS_CHECK(simulated.start().has_value());
  const haptics::AxisMapping axis;
  base::Random random(disturbance.seed);
  const int count = static_cast<int>(std::lround(duration_s / kTickS));
  std::vector<LoopTick> ticks(static_cast<std::size_t>(count));
  int last_served = -1;
  int stalled_until = 0;
  for (int i = 0; i <= count; ++i) {
    const haptics::DeviceState state = simulated.read(i * kTickNs);
    // The force of a tick is known when it is over.
    if (i > 0) ticks[static_cast<std::size_t>(i) - 1].force_n = simulated.trueForceN();
    if (i == count) break;
    ticks[static_cast<std::size_t>(i)].position_mm = simulated.truePositionMm();
    if (random.uniform() < disturbance.stalls_per_s * kTickS) stalled_until = i + 2 + random.below(4);
    const bool dropped = random.uniform() < disturbance.dropped_share;
    if (i < stalled_until || dropped) continue;
    const double force_n = servo(i * kTickS, axis.positionMm(state.position_mm), (i - last_served) * kTickS);
    simulated.write(axis.forceOnHand(force_n), i * kTickNs);
    last_served = i;
  }
  return ticks;
}

}  // namespace tactus::support
