// The safety layer under a scripted device, tick by tick: what its tests share.
#pragma once

#include <cstdint>

#include "core/haptics/safety/safety.h"

namespace tactus::haptics {

/// A device that works, a hand at rest, 1 ms ticks; tests change what they need between the ticks.
struct SafetyLoop {
  EnableSettings enable;
  LimitSettings limits;
  DeviceState device;
  SafetyInput input;
  double asked_n = 1;
  bool sampling = true;  ///< the device sends samples
  bool writing = true;   ///< forces reach the device
  Safety safety;
  LimitedForce out;
  std::int64_t now_ns = 1'000'000'000;

  double tick(double step_ms = 1) {
    now_ns += static_cast<std::int64_t>(1e6 * step_ms);
    if (sampling) {
      ++device.number;
      device.time_ns = now_ns;
    }
    if (writing) device.written_ns = now_ns;
    input.now_ns = now_ns;
    input.device = &device;
    safety.begin(input, enable, limits);
    out = safety.limit(asked_n, limits);
    input.stop = false;
    return out.force_n;
  }
  double ticks(int count) {
    for (int i = 0; i < count; ++i) tick();
    return out.force_n;
  }
  void press(bool down) { device.buttons = down ? 1 : 0; }
  bool limited(std::uint32_t bit) const { return (out.limited & bit) != 0; }

  /// Armed, pressed, faded in: the force is `asked_n`.
  void toFullForce() {
    press(false);
    input.armed = false;
    ticks(2);
    input.armed = true;
    ticks(2);
    press(true);
    ticks(1100);
  }
};

}  // namespace tactus::haptics
