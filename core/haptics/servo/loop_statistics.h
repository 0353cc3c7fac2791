// How punctual the servo is: lateness, gaps, the age of what it reads and writes, and how long a tick takes.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace tactus::haptics {

/// Counts of times in bins of equal ratio: two to an octave, [2^n, 1.5 2^n) and [1.5 2^n, 2^(n+1)) ns, from 256 ns to
/// 4.3 s, with one bin below and one above.
struct TimeHistogram {
  static constexpr int kFirstOctave = 8;  ///< 2^8 ns
  static constexpr int kLastOctave = 32;  ///< 2^32 ns
  static constexpr std::size_t kBins = 2 + 2 * (kLastOctave - kFirstOctave);

  std::array<std::uint64_t, kBins> counts{};
  std::int64_t largest_ns = 0;

  /// The bin of a time; below 0 counts as 0.
  static std::size_t binOf(std::int64_t time_ns) noexcept;
  /// Where a bin ends (that of the next begins); of the last, the largest number.
  static std::int64_t endNs(std::size_t bin) noexcept;

  std::uint64_t total() const noexcept;
  /// No more than this in `share` of all, (0, 1]: the end of the bin in which the share is reached, or the largest time
  /// where that is less. 0 without any.
  std::int64_t quantileNs(double share) const noexcept;
};

/// A snapshot.
struct LoopStatistics {
  std::uint64_t ticks = 0;
  std::uint64_t missed = 0;           ///< ticks that began more than a period too late
  std::int64_t longest_gap_ns = 0;    ///< between the beginnings of two ticks
  TimeHistogram lateness;             ///< of the beginning of a tick
  TimeHistogram tick_duration;        ///< from its beginning until its force is handed to the device
  TimeHistogram read_age;             ///< of the device's sample
  TimeHistogram write_age;            ///< since a force last reached the device
  std::uint64_t orders_taken = 0;     ///< sets of orders that came into force; others were overtaken by newer ones
  std::uint64_t last_wait_ticks = 0;  ///< from the last tick begun before `post` to the first with the new orders
  std::uint64_t longest_wait_ticks = 0;
  std::uint64_t restarts = 0;  ///< of the force, after a gap between commands that the device does not hold one for
};

/// Collects the statistics. One thread writes, any thread looks; all atomics are relaxed, because each number means
/// something by itself. Every function but `snapshot` belongs to the servo thread. Real-time safe: yes.
class LoopMeter {
 public:
  /// A tick begins.
  void begin(std::int64_t now_ns) noexcept;
  /// The loop ends for now: what follows until the next tick is no gap.
  void pause() noexcept { paused_ = true; }
  /// Ages at that tick.
  void readAge(std::int64_t age_ns) noexcept { read_age_.add(age_ns); }
  void writeAge(std::int64_t age_ns) noexcept { write_age_.add(age_ns); }
  /// New orders came into force `wait_ticks` ticks after they were posted.
  void ordersTaken(std::uint64_t wait_ticks) noexcept;
  /// How often the force began anew so far.
  void restarts(std::uint64_t count) noexcept { restarts_.store(count, std::memory_order_relaxed); }
  /// A tick has ended that began `late_ns` after its time (below 0: early) and took `duration_ns`.
  void end(std::int64_t late_ns, std::int64_t duration_ns, std::int64_t period_ns) noexcept;

  /// Ticks begun so far. Thread: any.
  std::uint64_t ticks() const noexcept { return ticks_.load(std::memory_order_relaxed); }
  /// Thread: any; single numbers may be of neighbouring ticks.
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
  bool paused_ = true;              ///< Touched by the servo thread alone: no tick to measure a gap from.
};

}  // namespace tactus::haptics
