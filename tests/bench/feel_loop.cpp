#include "tests/bench/feel_loop.h"

#include <limits>
#include <utility>

#include "core/base/check.h"
#include "core/haptics/simulated/virtual_device.h"

#include "tests/bench/cases.h"

namespace tactus::bench {

std::shared_ptr<const haptics::ServoScene> feelScene(const fuzzy::ForceModel& model) {
  haptics::SceneSettings settings;
  settings.largest_cost_s = std::numeric_limits<double>::infinity();
  auto scene = haptics::ServoScene::make(
      model, {{"lubrication", kFixedLubrication}, {"neck_flexion", kFixedNeckFlexionDeg}}, settings);
  TACTUS_CHECK(scene.has_value());
  return std::move(*scene);
}

haptics::ServoOrders feelOrders(std::shared_ptr<const haptics::ServoScene> scene) {
  const auto device = haptics::VirtualDevice::make();
  TACTUS_CHECK(device.has_value());
  haptics::ServoOrders orders;
  orders.source = haptics::ForceSource::kInsertion;
  orders.armed = true;
  orders.scene = std::move(scene);
  orders.limits = haptics::LimitSettings::forDevice((*device)->info());
  return orders;
}

haptics::ServoTick told(const haptics::DeviceState& device, const haptics::ServoOrders& orders) {
  haptics::ServoTick tick;
  tick.now_ns = device.time_ns;
  tick.device = device;
  tick.orders = &orders;
  tick.orders_number = 1;
  return tick;
}

FeelRun runFeelLoop(haptics::VirtualDeviceSettings settings, const haptics::ServoOrders& orders, int ticks,
                    int core_at) {
  const auto made = haptics::VirtualDevice::make(std::move(settings));
  TACTUS_CHECK(made.has_value());
  haptics::VirtualDevice& device = **made;
  TACTUS_CHECK(device.start().has_value());
  haptics::ServoCore core(device.info());
  FeelRun run{{}, core};
  for (int i = 0; i < ticks; ++i) {
    const std::int64_t now_ns = i * kFeelTickNs;
    FeelTick tick;
    tick.device = device.read(now_ns);
    if (i == core_at) run.core = core;
    tick.sample = core.tick(told(tick.device, orders));
    device.write(orders.axis.forceOnHand(tick.sample.force_n), now_ns);
    tick.true_position_mm = device.truePositionMm();
    tick.true_speed_mm_s = device.trueSpeedMmS();
    run.ticks.push_back(tick);
  }
  return run;
}

}  // namespace tactus::bench
