// A stylus with two buttons as a test double: the mechanics of the virtual device, but the program takes it for a real
// device. A hand moves it and presses its buttons; nothing is pressed by itself.
#pragma once

#include <atomic>
#include <memory>
#include <utility>

#include "app/workbench/device/virtual_time.h"
#include "core/base/check.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::tests {

class Stylus {
 public:
  /// Each run opens the same stylus, in the time of `time`, which outlives it.
  workbench::DeviceAccess access(workbench::VirtualTime& time) {
    workbench::DeviceAccess out;
    out.open_device = [held = held_](const std::string&) -> base::Result<devices::OpenedDevice> {
      devices::OpenedDevice opened;
      opened.device = std::make_unique<Device>(held);
      return opened;
    };
    out.make_loop = time.loops();
    return out;
  }

  void moveTo(double position_mm) { held_->target_mm = position_mm; }
  void press(bool down) { held_->down = down; }

 private:
  struct Held {
    std::atomic<double> target_mm{0};
    std::atomic<bool> down{false};
  };

  class Device final : public haptics::HapticDevice {
   public:
    explicit Device(std::shared_ptr<Held> held) : held_(std::move(held)) {
      auto made = haptics::VirtualDevice::make({});
      TACTUS_CHECK(made.has_value());
      inside_ = std::move(*made);
      info_ = inside_->info();
      info_.id = "hid:test-stylus";
      info_.name = "Stylus of the tests";
      info_.backend = "hid-pid";
      info_.simulated = false;
      info_.buttons = 2;
    }
    const haptics::DeviceInfo& info() const noexcept override { return info_; }
    base::Result<void> start() override { return inside_->start(); }
    void stop() noexcept override { inside_->stop(); }
    haptics::DeviceState read(std::int64_t now_ns) noexcept override {
      inside_->setTarget(held_->target_mm);
      inside_->setButton(held_->down);
      return inside_->read(now_ns);
    }
    void write(const haptics::Vector3& force_n, std::int64_t now_ns) noexcept override {
      inside_->write(force_n, now_ns);
    }

   private:
    std::shared_ptr<Held> held_;
    std::unique_ptr<haptics::VirtualDevice> inside_;
    haptics::DeviceInfo info_;
  };

  std::shared_ptr<Held> held_ = std::make_shared<Held>();
};

}  // namespace tactus::tests
