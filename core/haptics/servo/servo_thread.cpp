#include "core/haptics/servo/servo_thread.h"

#include <future>
#include <system_error>
#include <utility>

namespace tactus::haptics {

ServoThread::ServoThread(Servo& servo, ServoThreadSettings settings) : servo_(servo), settings_(settings) {}

ServoThread::~ServoThread() { stop(); }

base::Result<void> ServoThread::start() {
  if (state_.running) return {};
  state_ = {};
  if (DeviceLoop* const driver = servo_.device().ownLoop(); driver != nullptr) {
    auto ticks = std::make_unique<TimedTicks>(servo_, settings_.period_ns);
    if (auto started = driver->run(*ticks); !started) return started;
    driver_ticks_ = std::move(ticks);
    state_.own_loop = true;
  } else {
    ending_.store(false, std::memory_order_relaxed);
    std::promise<void> ready;
    std::future<void> is_ready = ready.get_future();
    try {
      thread_ = std::thread([this, ready = std::move(ready)]() mutable {
        state_.real_time = becomeRealTime(settings_.real_time);
        ready.set_value();
        loop();
      });
    } catch (const std::system_error& error) {
      return base::fail(base::ErrorCode::kLimit, "servo thread", error.code().message(), "a thread");
    }
    is_ready.wait();
  }
  state_.running = true;
  return {};
}

void ServoThread::stop() noexcept {
  if (!state_.running) return;
  if (driver_ticks_ != nullptr) {
    servo_.device().ownLoop()->end();
    driver_ticks_.reset();
    servo_.pause();
  } else {
    ending_.store(true, std::memory_order_relaxed);
    thread_.join();
  }
  state_.running = false;
}

void ServoThread::loop() noexcept {
  std::int64_t due_ns = monotonicNs() + settings_.period_ns;
  while (!ending_.load(std::memory_order_relaxed)) {
    sleepUntil(due_ns);
    const std::int64_t began_ns = monotonicNs();
    servo_.tick(began_ns);
    servo_.timed(began_ns - due_ns, monotonicNs() - began_ns, settings_.period_ns);
    due_ns = nextDueNs(due_ns, began_ns, settings_.period_ns);
  }
  servo_.release(monotonicNs());
}

void ServoThread::TimedTicks::tick(std::int64_t now_ns) noexcept {
  const std::int64_t late_ns = any_ ? now_ns - last_ns_ - period_ns_ : 0;
  any_ = true;
  last_ns_ = now_ns;
  const std::int64_t began_ns = monotonicNs();
  servo_.tick(now_ns);
  servo_.timed(late_ns, monotonicNs() - began_ns, period_ns_);
}

}  // namespace tactus::haptics
