#include "tests/gui/stepped_feel.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace tactus::tests {
namespace {

constexpr int kBeatMs = workbench::VirtualTime::kBeat;

}  // namespace

workbench::DeviceAccess SteppedFeel::settings() { return time_.access(device_); }

namespace {

/// Stops when it is told to; everything else is the device behind it.
class SlowDevice final : public haptics::HapticDevice {
 public:
  SlowDevice(std::unique_ptr<haptics::HapticDevice> device, const std::atomic<bool>& lets_go)
      : device_(std::move(device)), lets_go_(lets_go) {}

  const haptics::DeviceInfo& info() const noexcept override { return device_->info(); }
  base::Result<void> start() override {
    lets_go_.wait(false);
    return device_->start();
  }
  void stop() noexcept override {
    lets_go_.wait(false);
    device_->stop();
  }
  haptics::DeviceState read(std::int64_t now_ns) noexcept override { return device_->read(now_ns); }
  void write(const haptics::Vector3& force_n, std::int64_t now_ns) noexcept override {
    device_->write(force_n, now_ns);
  }

 private:
  std::unique_ptr<haptics::HapticDevice> device_;
  const std::atomic<bool>& lets_go_;
};

}  // namespace

workbench::DeviceAccess SteppedFeel::slowSettings(const std::atomic<bool>& lets_go) {
  workbench::DeviceAccess slow = settings();
  slow.open_device = [open = slow.open_device, &lets_go](const std::string& id) {
    auto opened = open(id);
    if (opened) opened->device = std::make_unique<SlowDevice>(std::move(opened->device), lets_go);
    return opened;
  };
  slow.is_slow = [](const std::string&) { return true; };
  return slow;
}

void SteppedFeel::stall(workbench::DeviceSession& session, int milliseconds) {
  for (int ms = 1; ms <= milliseconds; ++ms) {
    pass(1);
    if (ms % kBeatMs == 0 || ms == milliseconds) session.beat();
  }
}

void SteppedFeel::moveTo(workbench::DeviceSession& session, double position_mm, double speed_mm_s) {
  const double start_mm = session.targetMm();
  const double way_mm = position_mm - start_mm;
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(way_mm) / speed_mm_s * 1000 / kBeatMs)));
  for (int i = 1; i <= steps; ++i) {
    session.setTarget(start_mm + way_mm * i / steps);
    advance(session, kBeatMs);
  }
  advance(session, 100);
}

}  // namespace tactus::tests
