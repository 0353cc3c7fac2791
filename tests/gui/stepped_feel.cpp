#include "tests/gui/stepped_feel.h"

#include <algorithm>
#include <cmath>

#include "core/haptics/simulated/virtual_device.h"

namespace tactus::tests {
namespace {

constexpr std::int64_t kTickNs = 1'000'000;
constexpr int kBeatMs = 16;

}  // namespace

class SteppedFeel::Loop final : public workbench::ServoLoop {
 public:
  Loop(SteppedFeel& owner, haptics::Servo& servo) : owner_(owner), servo_(servo) { owner_.loop_ = this; }
  ~Loop() override { owner_.loop_ = nullptr; }

  base::Result<void> start() override {
    running_ = true;
    return {};
  }
  void stop() noexcept override {
    if (running_) servo_.release(owner_.now_ns_);
    running_ = false;
  }
  std::int64_t nowNs() const noexcept override { return owner_.now_ns_; }
  QString priorityText() const override { return QStringLiteral("virtual time"); }

  void tick() {
    if (!running_) return;
    servo_.tick(owner_.now_ns_);
    ++owner_.ticks_;
  }

 private:
  SteppedFeel& owner_;
  haptics::Servo& servo_;
  bool running_ = false;
};

workbench::DeviceAccess SteppedFeel::settings() {
  workbench::DeviceAccess settings;
  settings.open_device = [this](const std::string&) -> base::Result<devices::OpenedDevice> {
    auto device = haptics::VirtualDevice::make(device_);
    if (!device) return tl::unexpected(device.error());
    devices::OpenedDevice opened;
    opened.device = std::move(*device);
    return opened;
  };
  settings.make_loop = [this](haptics::Servo& servo) { return std::make_unique<Loop>(*this, servo); };
  return settings;
}

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

void SteppedFeel::advance(workbench::DeviceSession& session, int milliseconds) {
  for (int ms = 1; ms <= milliseconds; ++ms) {
    now_ns_ += kTickNs;
    if (loop_ != nullptr) loop_->tick();
    if (ms % kBeatMs == 0 || ms == milliseconds) session.beat();
  }
}

void SteppedFeel::hang(int milliseconds) {
  for (int ms = 0; ms < milliseconds; ++ms) {
    now_ns_ += kTickNs;
    if (loop_ != nullptr) loop_->tick();
  }
}

void SteppedFeel::stall(workbench::DeviceSession& session, int milliseconds) {
  for (int ms = 1; ms <= milliseconds; ++ms) {
    now_ns_ += kTickNs;
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
