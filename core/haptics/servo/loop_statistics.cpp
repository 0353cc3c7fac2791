#include "core/haptics/servo/loop_statistics.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

#include "core/haptics/device/device.h"

namespace tactus::haptics {
namespace {

constexpr auto kLongestHeldNs = static_cast<std::int64_t>(1e9 * ThermalBudget::kLongestHeldS);

}  // namespace

void ThermalFollower::add(const Sample& sample, const LimitSettings& limits) noexcept {
  const double rating_n = limits.continuous_force_n;
  if (begun_ && sample.time_ns - last_ns_ > kLongestHeldNs) {
    budget_.advance(last_ns_ + kLongestHeldNs, held_n_, rating_n, limits.thermal_window_s);
    held_n_ = 0;
  }
  budget_.advance(sample.time_ns, held_n_, rating_n, limits.thermal_window_s);
  begun_ = true;
  last_ns_ = sample.time_ns;
  held_n_ = sample.force_n / sample.scale;
}

namespace {

constexpr double kLongestLookS = 0.1;

}  // namespace

Trip LoopWatch::look(std::uint64_t ticks, std::int64_t now_ns) noexcept {
  const double since_s = looked_ ? std::min(secondsBetween(last_ns_, now_ns), kLongestLookS) : 0;
  silent_s_ = ticks == ticks_ ? silent_s_ + since_s : 0;
  looked_ = true;
  ticks_ = ticks;
  last_ns_ = now_ns;
  if (silent_s_ <= kSilentS) return {};
  return {TripCause::kServoLate, silent_s_, kSilentS, now_ns};
}

namespace {

// One writer: no read-modify-write is needed.
template <typename T>
void add(std::atomic<T>& number, T more) noexcept {
  number.store(number.load(std::memory_order_relaxed) + more, std::memory_order_relaxed);
}

template <typename T>
void raise(std::atomic<T>& largest, T value) noexcept {
  if (value > largest.load(std::memory_order_relaxed)) largest.store(value, std::memory_order_relaxed);
}

}  // namespace

std::size_t TimeHistogram::binOf(std::int64_t time_ns) noexcept {
  if (time_ns < std::int64_t{1} << kFirstOctave) return 0;
  const auto time = static_cast<std::uint64_t>(time_ns);
  const int octave = std::bit_width(time) - 1;
  if (octave >= kLastOctave) return kBins - 1;
  const auto upper_half = static_cast<std::size_t>((time >> (octave - 1)) & 1U);
  return 1 + 2 * static_cast<std::size_t>(octave - kFirstOctave) + upper_half;
}

std::int64_t TimeHistogram::endNs(std::size_t bin) noexcept {
  if (bin >= kBins - 1) return std::numeric_limits<std::int64_t>::max();
  const std::int64_t octave = std::int64_t{1} << (kFirstOctave + bin / 2);
  return bin % 2 == 0 ? octave : octave + octave / 2;
}

std::uint64_t TimeHistogram::total() const noexcept {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

std::int64_t TimeHistogram::quantileNs(double share) const noexcept {
  const std::uint64_t all = total();
  if (all == 0) return 0;
  const double wanted = share * static_cast<double>(all);
  std::uint64_t sum = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    sum += counts[bin];
    if (sum > 0 && static_cast<double>(sum) >= wanted) return std::min(endNs(bin), largest_ns);
  }
  return largest_ns;
}

void LoopMeter::AtomicHistogram::add(std::int64_t time_ns) noexcept {
  haptics::add(counts_[TimeHistogram::binOf(time_ns)], std::uint64_t{1});
  raise(largest_ns_, time_ns);
}

TimeHistogram LoopMeter::AtomicHistogram::snapshot() const noexcept {
  TimeHistogram out;
  for (std::size_t bin = 0; bin < TimeHistogram::kBins; ++bin)
    out.counts[bin] = counts_[bin].load(std::memory_order_relaxed);
  out.largest_ns = largest_ns_.load(std::memory_order_relaxed);
  return out;
}

void LoopMeter::begin(std::int64_t now_ns) noexcept {
  if (!paused_) raise(longest_gap_ns_, now_ns - last_begin_ns_);
  paused_ = false;
  last_begin_ns_ = now_ns;
  add(ticks_, std::uint64_t{1});
}

void LoopMeter::ordersTaken(std::uint64_t wait_ticks) noexcept {
  add(orders_taken_, std::uint64_t{1});
  last_wait_ticks_.store(wait_ticks, std::memory_order_relaxed);
  raise(longest_wait_ticks_, wait_ticks);
}

void LoopMeter::end(std::int64_t late_ns, std::int64_t duration_ns, std::int64_t period_ns) noexcept {
  lateness_.add(late_ns);
  tick_duration_.add(duration_ns);
  if (late_ns > period_ns) add(missed_, std::uint64_t{1});
}

LoopStatistics LoopMeter::snapshot() const noexcept {
  LoopStatistics out;
  out.ticks = ticks();
  out.missed = missed_.load(std::memory_order_relaxed);
  out.longest_gap_ns = longest_gap_ns_.load(std::memory_order_relaxed);
  out.lateness = lateness_.snapshot();
  out.tick_duration = tick_duration_.snapshot();
  out.read_age = read_age_.snapshot();
  out.write_age = write_age_.snapshot();
  out.orders_taken = orders_taken_.load(std::memory_order_relaxed);
  out.last_wait_ticks = last_wait_ticks_.load(std::memory_order_relaxed);
  out.longest_wait_ticks = longest_wait_ticks_.load(std::memory_order_relaxed);
  out.restarts = restarts_.load(std::memory_order_relaxed);
  return out;
}

}  // namespace tactus::haptics
