#include "app/workbench/device/servo_loop.h"

#include <QCoreApplication>

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

}  // namespace tactus::workbench
