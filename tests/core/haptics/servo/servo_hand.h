// A hand on a perfect device, for tests of the servo's tick.
#pragma once

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <utility>
#include <vector>

#include "core/haptics/servo/servo_core.h"

#include "tests/core/haptics/scenes.h"

namespace tactus::haptics {

/// Ticks of 1 ms. The hand begins armed, and pressed once the switch has been seen open.
struct ServoHand {
  ServoCore core;
  ServoOrders orders;
  ServoTick tick;
  Sample sample;
  double position_mm = 0;
  std::optional<Vector3> at_mm;  ///< where the device is; nothing: at `position_mm` along the axis of the orders
  double largest_step_n = 0;
  std::vector<ScenePointer> scenes;

  explicit ServoHand(ForceSource source, const DeviceInfo& device = {}) : core(device) {
    orders.source = source;
    orders.limits.fade_in_s = 0;
    tick.orders_number = 1;
    step(5);
    orders.armed = true;
    step(5);
    tick.device.buttons = 1;
    step(30);
    EXPECT_TRUE(sample.enabled);
  }

  /// As the mailbox hands it over; the old scene stays until the servo has seen the new one.
  void post(ScenePointer scene) {
    scenes.push_back(orders.scene);
    if (scenes.size() > 2) scenes.erase(scenes.begin());
    orders.scene = std::move(scene);
    ++tick.orders_number;
  }

  void step(int ticks = 1, double way_mm = 0) {
    for (int i = 0; i < ticks; ++i) {
      position_mm += way_mm / ticks;
      tick.now_ns += 1'000'000;
      tick.orders = &orders;
      ++tick.device.number;
      tick.device.time_ns = tick.device.written_ns = tick.now_ns;
      tick.device.position_mm = at_mm.value_or(orders.axis.originMm() + position_mm * orders.axis.inwards());
      const double before_n = sample.force_n;
      sample = core.tick(tick);
      largest_step_n = std::max(largest_step_n, std::abs(sample.force_n - before_n));
    }
  }
};

}  // namespace tactus::haptics
