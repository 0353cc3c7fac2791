#include "app/workbench/device/virtual_time.h"

#include <QCoreApplication>
#include <utility>

#include "app/workbench/device/device_session.h"
#include "core/base/error.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::workbench {

class VirtualTime::Loop final : public ServoLoop {
  Q_DECLARE_TR_FUNCTIONS(ServoLoop)

 public:
  Loop(VirtualTime& owner, haptics::Servo& servo) : owner_(owner), servo_(servo) { owner_.loop_ = this; }
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
  QString priorityText() const override { return tr("virtual time"); }

  void tick() {
    if (!running_) return;
    servo_.tick(owner_.now_ns_);
    ++owner_.ticks_;
  }

 private:
  VirtualTime& owner_;
  haptics::Servo& servo_;
  bool running_ = false;
};

MakeServoLoop VirtualTime::loops() {
  return [this](haptics::Servo& servo) { return std::make_unique<Loop>(*this, servo); };
}

DeviceAccess VirtualTime::access(haptics::VirtualDeviceSettings device) {
  DeviceAccess out;
  out.open_device = [settings = std::move(device)](const std::string&) -> base::Result<devices::OpenedDevice> {
    TACTUS_TRY(auto made, haptics::VirtualDevice::make(settings));
    devices::OpenedDevice opened;
    opened.device = std::move(made);
    return opened;
  };
  out.make_loop = loops();
  return out;
}

void VirtualTime::advance(DeviceSession& session, int milliseconds) {
  for (int ms = 1; ms <= milliseconds; ++ms) {
    hang(1);
    if (ms % kBeat == 0 || ms == milliseconds) session.beat();
  }
}

void VirtualTime::hang(int milliseconds) {
  for (int ms = 0; ms < milliseconds; ++ms) {
    pass(1);
    if (loop_ != nullptr) loop_->tick();
  }
}

}  // namespace tactus::workbench
