// The servo: one device, one core, orders in, samples out. A loop calls `tick`.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>

#include "core/haptics/device/device.h"
#include "core/haptics/safety/thermal_ledger.h"
#include "core/haptics/servo/flight_recorder.h"
#include "core/haptics/servo/loop_statistics.h"
#include "core/haptics/servo/mailbox.h"
#include "core/haptics/servo/sample.h"
#include "core/haptics/servo/sample_ring.h"
#include "core/haptics/servo/servo_core.h"
#include "core/haptics/servo/servo_orders.h"

namespace tactus::haptics {

/// Threads share only the mailbox (orders in), the ring (samples out), the tapes of the flight recorder, and single
/// atomics. docs/servo.md shows a picture.
class Servo final : public Ticked {
 public:
  /// `device`: its owner starts it and keeps it alive longer than the servo. `ledger`: null, or alive longer than the
  /// servo. The servo continues with the motor budget stored in the ledger and stores it again when it ends.
  explicit Servo(HapticDevice& device, ThermalLedger* ledger = nullptr);
  ~Servo() override;
  Servo(const Servo&) = delete;
  Servo& operator=(const Servo&) = delete;

  /// One tick: read, decide, limit, write, record. Thread: servo. Real-time safe: yes.
  void tick(std::int64_t now_ns) noexcept override;
  /// The timing of the tick that just ended, measured by the loop: how late it started and how long it took. For the
  /// statistics only. Thread: servo. Real-time safe: yes.
  void timed(std::int64_t late_ns, std::int64_t duration_ns, std::int64_t period_ns) noexcept {
    meter_.end(late_ns, duration_ns, period_ns);
  }
  /// The last call of our own loop: sets the force to zero, because no tick follows. Thread: servo. Real-time safe:
  /// yes.
  void release(std::int64_t now_ns) noexcept {
    device_.write({}, now_ns);
    pause();
  }
  /// The loop pauses and the device gives no force. The statistics count no gap, and the force restarts at the next
  /// tick. Thread: servo, or the owner while there is no servo thread.
  void pause() noexcept {
    meter_.pause();
    core_.toldNothing();
  }

  /// Passes new orders; the next tick uses them. Returns their number (from 1), which the samples carry. Also frees
  /// orders that the servo no longer uses.
  /// Limits and switch must be wellFormed. The poster must `check` the limits that a user sets.
  /// Thread: one poster. Real-time safe: no.
  std::uint64_t post(ServoOrders orders);
  /// Heartbeat of the program. Before the first one the servo expects none. Thread: any. Real-time safe: yes.
  void heartbeat(std::int64_t now_ns) noexcept { heartbeat_ns_.store(now_ns, std::memory_order_relaxed); }
  /// Sets the pedal or key down or up. Thread: any. Real-time safe: yes.
  void pedal(bool down) noexcept { pedal_.store(down, std::memory_order_relaxed); }
  /// No force from the next tick on; latched like a trip. Thread: any. Real-time safe: yes.
  void stop() noexcept { stop_.store(true, std::memory_order_relaxed); }

  /// Samples since the last call, oldest first; at most `room.size()`. Returns those filled. Samples that were lost
  /// because the reader did not drain show as a jump of Sample::tick: a recording ends there. Thread: one reader.
  std::span<Sample> drain(std::span<Sample> room) noexcept { return ring_.drain(room); }
  /// Ticks begun so far. Thread: any. Real-time safe: yes.
  std::uint64_t ticks() const noexcept { return meter_.ticks(); }
  /// Thread: any. A snapshot; single numbers may come from neighboring ticks.
  LoopStatistics statistics() const noexcept { return meter_.snapshot(); }
  /// Counts of evaluated and skipped inferences. Thread: any (a snapshot).
  render::SceneCounters sceneCounters() const noexcept;
  /// Used share of the thermal budget, [0, 1]. At 1 the motors must rest. Thread: any.
  double thermalShare() const noexcept { return thermal_share_.load(std::memory_order_relaxed); }
  /// The flight record of a trip not yet taken, or nothing. Thread: one reader. Real-time safe: no.
  std::optional<FlightRecord> takeFlightRecord() { return recorder_.take(); }

  HapticDevice& device() const noexcept { return device_; }

 private:
  struct Posted {
    ServoOrders orders;
    std::uint64_t at_tick = 0;  ///< the last tick started before they were posted
  };

  void publish() noexcept;

  HapticDevice& device_;
  ThermalLedger* ledger_;
  ServoCore core_;            ///< Touched by the servo thread alone.
  const Posted no_orders_;    ///< In effect until the first orders are posted.
  std::uint64_t orders_ = 0;  ///< Touched by the servo thread alone. Number of the orders in effect.

  Mailbox<Posted> mailbox_;
  SampleRing ring_;
  FlightRecorder recorder_;
  LoopMeter meter_;

  // Written by any thread, read by the servo. Relaxed, because each is independent.
  alignas(64) std::atomic<bool> stop_{false};  ///< The servo resets it after reading it.
  std::atomic<bool> pedal_{false};
  std::atomic<std::int64_t> heartbeat_ns_{0};

  // Written by the servo, read by any thread. Relaxed, because each is independent.
  alignas(64) std::atomic<double> thermal_share_{0};
  std::atomic<std::uint64_t> scene_ticks_{0};
  std::atomic<std::uint64_t> scene_asked_{0};
  std::atomic<std::uint64_t> scene_released_{0};
  std::atomic<std::uint64_t> scene_unchanged_{0};
};

}  // namespace tactus::haptics
