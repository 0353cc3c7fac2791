// The servo: one device, one core, orders in, samples out. Whoever has a clock calls `tick`.
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

/// Between the threads stand only the mailbox (orders in), the ring (samples out), the tapes of the flight recorder,
/// and single atomics. docs/servo.md has the picture.
class Servo final : public Ticked {
 public:
  /// `device` must outlive the servo and be started by its owner. `ledger`, where there is one, outlives it too: the
  /// budget of the device's motors goes on where the servo before left it, and is written down when this one ends.
  explicit Servo(HapticDevice& device, ThermalLedger* ledger = nullptr);
  ~Servo() override;
  Servo(const Servo&) = delete;
  Servo& operator=(const Servo&) = delete;

  /// One tick: read, decide, limit, write, record. Thread: servo. Real-time safe: yes.
  void tick(std::int64_t now_ns) noexcept override;
  /// What whoever has the clock saw at the tick that just ended: how much later than planned it began, and how long it
  /// took. For the statistics alone. Thread: servo. Real-time safe: yes.
  void timed(std::int64_t late_ns, std::int64_t duration_ns, std::int64_t period_ns) noexcept {
    meter_.end(late_ns, duration_ns, period_ns);
  }
  /// The last act of a loop of ours: no force, because no tick will follow. Thread: servo. Real-time safe: yes.
  void release(std::int64_t now_ns) noexcept {
    device_.write({}, now_ns);
    pause();
  }
  /// The loop ends for now, and the device gives no force: the statistics see no gap in it, and the force begins anew
  /// at the next tick. Thread: servo, or its owner while there is none.
  void pause() noexcept {
    meter_.pause();
    core_.toldNothing();
  }

  /// Hands over new orders; the next tick uses them. Returns their number (from 1), which samples carry. Orders that
  /// the servo does not read any more are freed here. Limits and switch are wellFormed; what a person may set is for
  /// the poster to `check` before. Thread: one poster. Real-time safe: no.
  std::uint64_t post(ServoOrders orders);
  /// Sign of life of the program. Without the first one none is expected. Thread: any. Real-time safe: yes.
  void heartbeat(std::int64_t now_ns) noexcept { heartbeat_ns_.store(now_ns, std::memory_order_relaxed); }
  /// Pedal or key down or up. Thread: any. Real-time safe: yes.
  void pedal(bool down) noexcept { pedal_.store(down, std::memory_order_relaxed); }
  /// No force from the next tick on, latched like a trip. Thread: any. Real-time safe: yes.
  void stop() noexcept { stop_.store(true, std::memory_order_relaxed); }

  /// Samples since the last call, oldest first; at most `room.size()`. Returns those filled. Samples that were lost
  /// because nobody drained show as a jump of Sample::tick: a recording ends there. Thread: one reader.
  std::span<Sample> drain(std::span<Sample> room) noexcept { return ring_.drain(room); }
  /// Ticks begun so far. Thread: any. Real-time safe: yes.
  std::uint64_t ticks() const noexcept { return meter_.ticks(); }
  /// Thread: any (a snapshot; single numbers may be of neighbouring ticks).
  LoopStatistics statistics() const noexcept { return meter_.snapshot(); }
  /// How much inference was needed so far. Thread: any (a snapshot).
  SceneCounters sceneCounters() const noexcept;
  /// Share of the thermal budget in use, [0, 1]; 1: the device rests. Thread: any.
  double thermalShare() const noexcept { return thermal_share_.load(std::memory_order_relaxed); }
  /// The flight record of a trip that has not been taken yet, or nothing. Thread: one reader. Real-time safe: no.
  std::optional<FlightRecord> takeFlightRecord() { return recorder_.take(); }

  HapticDevice& device() const noexcept { return device_; }

 private:
  struct Posted {
    ServoOrders orders;
    std::uint64_t at_tick = 0;  ///< the last tick begun when they were posted
  };

  void publish() noexcept;

  HapticDevice& device_;
  ThermalLedger* ledger_;
  ServoCore core_;            ///< Touched by the servo thread alone.
  const Posted no_orders_;    ///< In force until the first are posted.
  std::uint64_t orders_ = 0;  ///< Touched by the servo thread alone. Number of the orders in force.

  Mailbox<Posted> mailbox_;
  SampleRing ring_;
  FlightRecorder recorder_;
  LoopMeter meter_;

  // Written by any thread, read by the servo. Each stands for itself: relaxed.
  alignas(64) std::atomic<bool> stop_{false};  ///< Also taken back by the servo, once it has seen it.
  std::atomic<bool> pedal_{false};
  std::atomic<std::int64_t> heartbeat_ns_{0};

  // Written by the servo, read by any thread. Each stands for itself: relaxed.
  alignas(64) std::atomic<double> thermal_share_{0};
  std::atomic<std::uint64_t> scene_ticks_{0};
  std::atomic<std::uint64_t> scene_asked_{0};
  std::atomic<std::uint64_t> scene_released_{0};
  std::atomic<std::uint64_t> scene_unchanged_{0};
};

}  // namespace tactus::haptics
