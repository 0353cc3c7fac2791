// The thread that calls the servo once per millisecond, or the driver's own that does.
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

/// For the screen.
struct ServoThreadState {
  bool running = false;
  bool own_loop = false;  ///< the device's driver calls; its priority is the driver's affair, and unknown
  RealTime real_time;     ///< what was permitted, of a thread of ours
};

struct ServoThreadSettings {
  std::int64_t period_ns = 1'000'000;
  RealTimeWish real_time;
};

/// A loop that is later than this many periods does not catch up: the missed ticks are left out.
inline constexpr int kMostPeriodsLate = 5;

/// When the next tick is due after one that was due at `due_ns` and began at `began_ns`: a period later, or a period
/// after its beginning where it was more than kMostPeriodsLate periods late.
constexpr std::int64_t nextDueNs(std::int64_t due_ns, std::int64_t began_ns, std::int64_t period_ns) noexcept {
  return (began_ns - due_ns > kMostPeriodsLate * period_ns ? began_ns : due_ns) + period_ns;
}

/// Runs a servo between `start` and `stop`. All functions belong to the thread that owns it; the destructor stops.
/// The device must be started first and stopped last.
class ServoThread {
 public:
  explicit ServoThread(Servo& servo, ServoThreadSettings settings = {});
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// Returns when the loop runs. Refused: the system gives no thread, or the driver's loop does not start. Already
  /// running: nothing happens. May be called again after `stop`.
  base::Result<void> start();
  /// Returns when no tick will follow and the device has been told to give no force. May be called twice.
  void stop() noexcept;

  const ServoThreadState& state() const noexcept { return state_; }

 private:
  /// Times the ticks that a driver calls; lateness is against a period after the tick before.
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
  ServoThreadState state_;           ///< Written by the owner, and by the new thread while `start` waits for it.
  std::atomic<bool> ending_{false};  ///< Written by the owner, read by the servo thread.
  std::thread thread_;
  std::unique_ptr<TimedTicks> driver_ticks_;  ///< Exists while a driver's loop runs.
};

}  // namespace tactus::haptics
