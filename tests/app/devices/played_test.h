// The self-test on a virtual device in virtual time, with a person and a device that a test can make worse.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/devices/guided_runs.h"
#include "core/haptics/servo/servo.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::devices {

/// A device in front of another one, which a test changes on the way.
class Altered final : public haptics::HapticDevice {
 public:
  explicit Altered(haptics::HapticDevice& device) : device_(device) {}

  const haptics::DeviceInfo& info() const noexcept override { return device_.info(); }
  base::Result<void> start() override { return device_.start(); }
  void stop() noexcept override { device_.stop(); }
  haptics::DeviceState read(std::int64_t now_ns) noexcept override {
    haptics::DeviceState state = device_.read(now_ns);
    if (on_read) on_read(state);
    return state;
  }
  void write(const haptics::Vector3& force_n, std::int64_t now_ns) noexcept override {
    device_.write(force_factor * force_n, now_ns);
  }

  std::function<void(haptics::DeviceState&)> on_read;
  double force_factor = 1;

 private:
  haptics::HapticDevice& device_;
};

struct Played {
  SelfTestSettings settings;
  haptics::VirtualDeviceSettings device;
  std::function<void(haptics::DeviceState&)> on_read;
  double force_factor = 1;
  Felt felt = Felt::kToward;
  /// What the person does; by default what is asked. `tick`: of the phase, from 1.
  std::function<void(haptics::VirtualDevice&, SelfTest::Phase, int tick)> person = dutiful;

  static void dutiful(haptics::VirtualDevice& device, SelfTest::Phase phase, int tick) {
    using Phase = SelfTest::Phase;
    if (phase == Phase::kMotion) device.setTarget(tick < 800 ? 40 : 0);
    device.setButton((phase == Phase::kButton && tick > 800 && tick < 900) ||
                     (phase == Phase::kForceOff && tick > 100) || phase == Phase::kPulse);
  }

  /// The test as it ended; it must end within two virtual minutes.
  SelfTest run() const {
    const auto made = haptics::VirtualDevice::make(device);
    haptics::VirtualDevice& virtual_device = **made;
    Altered altered(virtual_device);
    altered.on_read = on_read;
    altered.force_factor = force_factor;
    (void)altered.start();
    haptics::Servo servo(altered);
    SelfTest test(settings);
    SelfTest::Phase phase = test.phase();
    int tick = 0;
    for (std::int64_t now_ns = 1'000'000; !test.finished() && now_ns < 120'000'000'000; now_ns += 1'000'000) {
      if (auto orders = test.takeOrders()) test.posted(servo.post(std::move(*orders)));
      servo.tick(now_ns);
      haptics::Sample room[2];
      for (const auto& sample : servo.drain(room)) test.feed(sample);
      if (const auto record = servo.takeFlightRecord()) test.tripped(record->trip);
      if (test.phase() == SelfTest::Phase::kAsk) test.answer(felt);
      tick = test.phase() == phase ? tick + 1 : 1;
      phase = test.phase();
      person(virtual_device, phase, tick);
    }
    return test;
  }
};

}  // namespace tactus::devices
