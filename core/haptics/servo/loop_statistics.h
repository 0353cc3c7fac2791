// How punctual the servo is: lateness, gaps, ages of samples and writes, and the duration of a tick.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/safety/safety.h"
#include "core/haptics/safety/thermal_budget.h"
#include "core/haptics/servo/sample.h"

namespace tactus::haptics {

// The thermal budget of a running servo, followed from its samples.

/// Only the servo thread knows its budget. The reader of the samples needs it, too: how long a rest must be before the
/// next force (thermal_rest.h). Where samples were lost, the last force before the gap counts for the gap, for at most
/// 2 s. Plain state. Thread: the reader of the samples. Real-time safe: yes.
class ThermalFollower {
 public:
  /// `thermal`: the load before the servo started, from the ledger.
  explicit ThermalFollower(const ThermalBudget& thermal = {}) noexcept : budget_(thermal) {}

  /// All samples, oldest first. `limits`: those of the orders in effect.
  void add(const Sample& sample, const LimitSettings& limits) noexcept;

  /// The budget at the time of the last sample.
  const ThermalBudget& budget() const noexcept { return budget_; }

 private:
  ThermalBudget budget_;
  bool begun_ = false;
  std::int64_t last_ns_ = 0;
  double held_n_ = 0;
};

// Detects a loop that has stopped calling the servo.

/// If the loop of a driver stops, it reports nothing, and a servo that is not called cannot trip. So another thread
/// calls `look` regularly, about 60 times a second. A pause between two calls counts as at most 0.1 s: if the whole
/// program stood still, the loop gets time to continue.
class LoopWatch {
 public:
  static constexpr double kSilentS = 1;  ///< without a tick for this time, the loop counts as dead

  /// `ticks`: from Servo::ticks. `now_ns`: on a monotonic clock. Returns kServoLate if the loop is dead, else no trip.
  Trip look(std::uint64_t ticks, std::int64_t now_ns) noexcept;

 private:
  bool looked_ = false;
  std::uint64_t ticks_ = 0;
  std::int64_t last_ns_ = 0;
  double silent_s_ = 0;
};

/// A histogram of times in bins of equal ratio. Each octave has two bins, [2^n, 1.5 2^n) and [1.5 2^n, 2^(n+1)) ns,
/// from 256 ns to 4.3 s. One more bin lies below, one above.
struct TimeHistogram {
  static constexpr int kFirstOctave = 8;  ///< 2^8 ns
  static constexpr int kLastOctave = 32;  ///< 2^32 ns
  static constexpr std::size_t kBins = 2 + 2 * (kLastOctave - kFirstOctave);

  std::array<std::uint64_t, kBins> counts{};
  std::int64_t largest_ns = 0;

  /// The bin of a time. A negative time counts as 0.
  static std::size_t binOf(std::int64_t time_ns) noexcept;
  /// The end of a bin, which is the start of the next. For the last bin: the largest number.
  static std::int64_t endNs(std::size_t bin) noexcept;

  std::uint64_t total() const noexcept;
  /// The `share` quantile, `share` in (0, 1]: the end of the bin that reaches the share, or the largest time if that is
  /// less. 0 if the histogram is empty.
  std::int64_t quantileNs(double share) const noexcept;
};

/// A snapshot of the statistics.
struct LoopStatistics {
  std::uint64_t ticks = 0;
  std::uint64_t missed = 0;           ///< ticks that began more than a period too late
  std::int64_t longest_gap_ns = 0;    ///< between the starts of two ticks
  TimeHistogram lateness;             ///< of the start of a tick
  TimeHistogram tick_duration;        ///< from the start of a tick until the force is handed to the device
  TimeHistogram read_age;             ///< age of the device's sample
  TimeHistogram write_age;            ///< time since a force last reached the device
  std::uint64_t orders_taken = 0;     ///< sets of orders that took effect; newer ones replaced the others before
  std::uint64_t last_wait_ticks = 0;  ///< from the last tick started before `post` to the first with the new orders
  std::uint64_t longest_wait_ticks = 0;
  std::uint64_t restarts = 0;  ///< of the force, after a gap between commands longer than the device holds one
};

/// Collects the statistics. One thread writes, any thread reads. All atomics are relaxed, because each number is
/// independent. All functions except `ticks` and `snapshot` belong to the servo thread. Real-time safe: yes.
class LoopMeter {
 public:
  /// Records the start of a tick.
  void begin(std::int64_t now_ns) noexcept;
  /// The loop pauses: the time until the next tick is not a gap.
  void pause() noexcept { paused_ = true; }
  /// Records ages at the current tick.
  void readAge(std::int64_t age_ns) noexcept { read_age_.add(age_ns); }
  void writeAge(std::int64_t age_ns) noexcept { write_age_.add(age_ns); }
  /// New orders took effect `wait_ticks` ticks after they were posted.
  void ordersTaken(std::uint64_t wait_ticks) noexcept;
  /// Sets how many times the force has restarted so far.
  void restarts(std::uint64_t count) noexcept { restarts_.store(count, std::memory_order_relaxed); }
  /// Records the end of a tick that started `late_ns` after its time (below 0: early) and took `duration_ns`.
  void end(std::int64_t late_ns, std::int64_t duration_ns, std::int64_t period_ns) noexcept;

  /// Number of ticks started so far. Thread: any.
  std::uint64_t ticks() const noexcept { return ticks_.load(std::memory_order_relaxed); }
  /// Thread: any. Single numbers may come from neighboring ticks.
  LoopStatistics snapshot() const noexcept;

 private:
  template <typename T>
  using Number = std::atomic<T>;  ///< Written by the servo thread, read by any.

  class AtomicHistogram {
   public:
    void add(std::int64_t time_ns) noexcept;
    TimeHistogram snapshot() const noexcept;

   private:
    std::array<Number<std::uint64_t>, TimeHistogram::kBins> counts_{};
    Number<std::int64_t> largest_ns_{0};
  };

  Number<std::uint64_t> ticks_{0};
  Number<std::uint64_t> missed_{0};
  Number<std::int64_t> longest_gap_ns_{0};
  Number<std::uint64_t> orders_taken_{0};
  Number<std::uint64_t> last_wait_ticks_{0};
  Number<std::uint64_t> longest_wait_ticks_{0};
  Number<std::uint64_t> restarts_{0};
  AtomicHistogram lateness_;
  AtomicHistogram tick_duration_;
  AtomicHistogram read_age_;
  AtomicHistogram write_age_;
  std::int64_t last_begin_ns_ = 0;  ///< Touched by the servo thread alone.
  bool paused_ = true;              ///< Touched by the servo thread alone: there is no tick to measure a gap from.
};

}  // namespace tactus::haptics
