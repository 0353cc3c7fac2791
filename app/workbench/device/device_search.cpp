#include "app/workbench/device/device_search.h"

#include <QCoreApplication>
#include <chrono>

#include "core/haptics/servo/servo.h"
#include "core/haptics/servo/servo_clock.h"

namespace tactus::workbench {
namespace {

class ThreadedLoop final : public ServoLoop {
  Q_DECLARE_TR_FUNCTIONS(ServoLoop)

 public:
  explicit ThreadedLoop(haptics::Servo& servo) : thread_(servo) {}

  base::Result<void> start() override { return thread_.start(); }
  void stop() noexcept override { thread_.stop(); }
  std::int64_t nowNs() const noexcept override { return haptics::monotonicNs(); }

  QString priorityText() const override {
    const haptics::ServoThreadState& state = thread_.state();
    if (state.own_loop) return tr("loop of the driver");
    return state.real_time.priority > 0 ? tr("real-time thread") : tr("ordinary thread");
  }

 private:
  haptics::ServoThread thread_;
};

}  // namespace

std::unique_ptr<ServoLoop> threadedLoop(haptics::Servo& servo) { return std::make_unique<ThreadedLoop>(servo); }

DeviceAccess realDevices() {
  // A device behind a driver may take seconds; the virtual one is there at once.
  DeviceAccess access;
  access.open_device = [](const std::string& id) { return devices::open(id, devices::settingsOfProcess()); };
  access.make_loop = threadedLoop;
  access.is_slow = [](const std::string& id) { return id != "virtual"; };
  return access;
}

namespace {

constexpr int kPollMs = 50;

}  // namespace

DeviceSearch::DeviceSearch(QObject* parent) : QObject(parent), list_(devices::listOf({}, {}, {}, {})) {
  // What was not looked for yet is nothing to remark on.
  list_.notes.clear();
  poll_.setInterval(kPollMs);
  connect(&poll_, &QTimer::timeout, this, &DeviceSearch::look);
}

void DeviceSearch::search() {
  if (isSearching()) return;
  pending_ = std::async(std::launch::async,
                        [settings = devices::settingsOfProcess()] { return devices::listDevices(settings); });
  poll_.start();
  emit searching();
}

void DeviceSearch::look() {
  if (pending_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  poll_.stop();
  list_ = pending_.get();
  emit found();
}

}  // namespace tactus::workbench
