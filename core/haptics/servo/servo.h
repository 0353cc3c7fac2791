// The servo: one device, one core, orders in, samples out. A loop calls `tick`.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/device/device.h"
#include "core/haptics/safety/safety.h"
#include "core/haptics/safety/thermal_budget.h"
#include "core/haptics/servo/loop_statistics.h"
#include "core/haptics/servo/mailbox.h"
#include "core/haptics/servo/sample.h"
#include "core/haptics/servo/servo_clock.h"
#include "core/haptics/servo/servo_core.h"

namespace tactus::haptics {

// Keeps the ticks around a trip, so that the user can find its cause.

/// The first trip since arming, with the ticks before and after it.
struct FlightRecord {
  Trip trip;
  std::vector<Sample> samples;  ///< oldest first
};

/// Two tapes (rings of samples), allocated in advance. The writer records on one. A fixed number of ticks after a trip
/// it passes that tape to the reader and continues on the other, so no thread waits. If the reader holds both tapes,
/// the writer records nothing.
/// A latched trip makes one record. If it is cleared and a new trip occurs, that makes the next record. A trip within
/// the ticks after another one belongs to the record of the first.
class FlightRecorder {
 public:
  static constexpr std::size_t kTicksBefore = 4000;  ///< 4 s at 1 kHz: a whole stroke with its approach
  static constexpr std::size_t kTicksAfter = 200;    ///< 0.2 s: until the force is zero and the hand has let go

  /// A record holds at most `before` ticks before the trip, the tick of the trip, and `after` ticks.
  explicit FlightRecorder(std::size_t before = kTicksBefore, std::size_t after = kTicksAfter);

  /// Records one tick. `latched`: the trip latched at its end, or none.
  /// Thread: writer. Real-time safe: yes.
  void record(const Sample& sample, const Trip& latched) noexcept;

  /// The oldest record not yet taken, or nothing. Thread: reader. Real-time safe: no.
  std::optional<FlightRecord> take();

 private:
  struct Tape {
    std::vector<Sample> samples;  ///< a ring
    std::uint64_t recorded = 0;   ///< ticks since the start of the tape
    Trip trip;
    /// True: the reader owns the tape and the members above, until it sets false again. Release and acquire both ways.
    std::atomic<bool> full{false};
  };

  std::array<Tape, 2> tapes_;
  std::size_t after_;

  // Touched by the writer alone.
  std::size_t writing_ = 0;  ///< index of the tape
  std::size_t left_ = 0;     ///< ticks until the tape is full, counted after the trip
  Trip seen_;                ///< the latched trip at the last tick

  std::size_t reading_ = 0;  ///< Touched by the reader alone: index of the tape that becomes full next; they alternate.
};

// Passes all samples from the servo to a recording or drawing reader, without a lock.

/// One writer, one reader, oldest sample first. If the ring is full, new samples are dropped and counted. Samples in
/// the ring are never overwritten.
class SampleRing {
 public:
  /// 16 s at 1 kHz: longer than the reader waits for a slow disk.
  static constexpr std::size_t kDefaultCapacity = 16384;

  /// `capacity`: > 0, number of samples. The constructor allocates and touches all memory.
  explicit SampleRing(std::size_t capacity = kDefaultCapacity);

  /// Thread: writer. Real-time safe: yes.
  void push(const Sample& sample) noexcept;

  /// Moves the oldest samples into `room`, as many as fit. Returns the filled part.
  /// Thread: reader. Real-time safe: yes.
  std::span<Sample> drain(std::span<Sample> room) noexcept;

  /// Number of samples dropped because the ring was full. Thread: any. Real-time safe: yes.
  std::uint64_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }
  std::size_t capacity() const noexcept { return places_.size(); }

 private:
  /// Written by the writer with release after the sample; read by the reader with acquire. Never wraps in practice.
  alignas(64) std::atomic<std::uint64_t> written_{0};
  std::atomic<std::uint64_t> dropped_{0};  ///< Written by the writer alone.
  std::uint64_t seen_read_ = 0;            ///< Touched by the writer alone: `read_` at the last check.
  /// Places from `read_` to `written_` (modulo the size) belong to the reader, all others to the writer.
  std::vector<Sample> places_;

  /// Written by the reader with release after the copy; read by the writer with acquire. Never wraps in practice.
  alignas(64) std::atomic<std::uint64_t> read_{0};
};

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

// The thread that calls the servo once per millisecond. If the driver has its own loop, that loop calls instead.

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
