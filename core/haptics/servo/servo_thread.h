// The thread that calls the servo once per millisecond. If the driver has its own loop, that loop calls instead.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

#include "core/base/error.h"
#include "core/haptics/device/device.h"
#include "core/haptics/servo/servo.h"
#include "core/haptics/servo/servo_clock.h"

namespace tactus::haptics {

/// The state for display.
struct ServoThreadState {
  bool running = false;
  bool own_loop = false;  ///< the device's driver calls the servo; the priority of its thread is unknown
  RealTime real_time;     ///< permissions of our own thread
};

struct ServoThreadSettings {
  std::int64_t period_ns = 1'000'000;
  RealTimeWish real_time;
};

/// If a loop is later than this many periods, it skips the missed ticks instead of catching up.
inline constexpr int kMostPeriodsLate = 5;

/// The due time of the next tick, after a tick that was due at `due_ns` and started at `began_ns`: one period later. If
/// that tick was more than kMostPeriodsLate periods late: one period after its start.
constexpr std::int64_t nextDueNs(std::int64_t due_ns, std::int64_t began_ns, std::int64_t period_ns) noexcept {
  return (began_ns - due_ns > kMostPeriodsLate * period_ns ? began_ns : due_ns) + period_ns;
}

/// Runs a servo between `start` and `stop`. All functions belong to the owner's thread; the destructor stops. The owner
/// starts the device before `start` and stops it after `stop`.
class ServoThread {
 public:
  explicit ServoThread(Servo& servo, ServoThreadSettings settings = {});
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// Returns when the loop runs. Returns an error if the system gives no thread or the driver's loop does not start. No
  /// effect if the servo already runs. May be called again after `stop`.
  base::Result<void> start();
  /// Returns after the last tick, when the device has been told to give no force. May be called twice.
  void stop() noexcept;

  const ServoThreadState& state() const noexcept { return state_; }

 private:
  /// Times the ticks that a driver calls. The planned time of a tick is one period after the previous one.
  class TimedTicks final : public Ticked {
   public:
    TimedTicks(Servo& servo, std::int64_t period_ns) : servo_(servo), period_ns_(period_ns) {}
    void tick(std::int64_t now_ns) noexcept override;

   private:
    Servo& servo_;
    std::int64_t period_ns_;
    std::int64_t last_ns_ = 0;
    bool any_ = false;
  };

  void loop() noexcept;

  Servo& servo_;
  const ServoThreadSettings settings_;
  ServoThreadState state_;           ///< Written by the owner; also by the new thread while `start` waits for it.
  std::atomic<bool> ending_{false};  ///< Written by the owner, read by the servo thread.
  std::thread thread_;
  std::unique_ptr<TimedTicks> driver_ticks_;  ///< Not null while a driver's loop runs.
};

}  // namespace tactus::haptics
