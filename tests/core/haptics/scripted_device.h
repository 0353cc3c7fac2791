// A haptic device for tests: gives what the test says, remembers what it was told. Any thread may set what it gives.
#pragma once

#include <atomic>
#include <cstdint>

#include "core/haptics/device/device.h"

namespace tactus::haptics {

class ScriptedDevice final : public HapticDevice {
 public:
  ScriptedDevice() {
    info_.id = "scripted";
    info_.backend = "scripted";
    info_.simulated = true;
    info_.max_force_n = 3.3;
    info_.damping_n_s_mm = 0.0002;
  }

  const DeviceInfo& info() const noexcept override { return info_; }
  base::Result<void> start() override { return {}; }
  void stop() noexcept override {}

  DeviceState read(std::int64_t now_ns) noexcept override {
    if (!silent) {
      state_.number = ++samples;
      state_.time_ns = now_ns - age_ns;
      if (pressed && samples > released_samples) position_mm = position_mm + mm_per_sample;
    }
    state_.position_mm = {0, 0, -position_mm};  // the axis goes inwards along -z
    // A hand presses after it was seen not to.
    state_.buttons = pressed && samples > released_samples ? 1 : 0;
    state_.fault = fault;
    return state_;
  }

  void write(const Vector3& force_n, std::int64_t now_ns) noexcept override {
    x_n = force_n.x;
    y_n = force_n.y;
    z_n = force_n.z;
    if (force_n != Vector3{}) ++forces;
    if (!stuck) state_.written_ns = now_ns;
    ++writes;
  }

  DeviceLoop* ownLoop() noexcept override { return own_loop; }

  // What it gives.
  std::atomic<double> position_mm{0};
  std::atomic<bool> pressed{false};
  std::atomic<double> mm_per_sample{0};            ///< moves inwards by so much while it is pressed
  std::atomic<std::uint64_t> released_samples{0};  ///< the button is up at least so long
  std::atomic<std::int64_t> age_ns{0};
  std::atomic<bool> silent{false};  ///< no new samples
  std::atomic<bool> stuck{false};   ///< no force reaches the device
  std::atomic<DeviceFault> fault{DeviceFault::kNone};
  DeviceLoop* own_loop = nullptr;

  // What it was told.
  std::atomic<std::uint64_t> samples{0};
  std::atomic<std::uint64_t> writes{0};
  std::atomic<std::uint64_t> forces{0};  ///< writes that were not zero
  std::atomic<double> x_n{0}, y_n{0}, z_n{0};

 private:
  DeviceInfo info_;
  DeviceState state_;
};

}  // namespace tactus::haptics
