#include "core/haptics/safety/velocity_guard.h"

#include <algorithm>

namespace tactus::haptics {
namespace {

constexpr std::int64_t kSpanNs = 15'000'000;
constexpr std::int64_t kShortestSpanNs = 8'000'000;
constexpr std::int64_t kClosestNs = 500'000;

/// Of the first `count` values, which it sorts.
template <class Value, std::size_t kSize>
Value median(std::array<Value, kSize>& values, int count) noexcept {
  const auto middle = values.begin() + count / 2;
  std::nth_element(values.begin(), middle, values.begin() + count);
  return *middle;
}

}  // namespace

void VelocityGuard::add(std::uint64_t number, std::int64_t time_ns, double position_mm) noexcept {
  if (number == number_) {
    // Renewed and nothing else: a device that is silent when still. After a whole window of it the hand rests.
    if (count_ > 0 && time_ns - back(0).time_ns >= kSpanNs) speed_mm_s_ = 0;
    return;
  }
  number_ = number;
  if (count_ > 0 && time_ns < back(0).time_ns) count_ = 0;  // another clock or another device
  if (count_ > 0 && time_ns - back(0).time_ns < kClosestNs) return;
  newest_ = count_ == 0 ? kRoom : newest_ + 1;
  if (newest_ >= 2 * kRoom) newest_ -= kRoom;
  points_[static_cast<std::size_t>(newest_) % kRoom] = {time_ns, position_mm};
  count_ = std::min(count_ + 1, kRoom);
  speed_mm_s_ = fitted();
}

Trip VelocityGuard::check(const LimitSettings& limits) const noexcept {
  if (!limits.guard_velocity) return {};
  if (speed_mm_s_ > limits.inward_guard_mm_s)
    return {TripCause::kTooFastInwards, speed_mm_s_, limits.inward_guard_mm_s, 0};
  if (-speed_mm_s_ > limits.outward_guard_mm_s)
    return {TripCause::kTooFastOutwards, -speed_mm_s_, limits.outward_guard_mm_s, 0};
  return {};
}

double VelocityGuard::fitted() const noexcept {
  int used = 1;
  while (used < count_ && back(0).time_ns - back(used - 1).time_ns < kSpanNs) ++used;
  if (back(0).time_ns - back(used - 1).time_ns < kShortestSpanNs) return 0;

  std::array<std::int64_t, kRoom> late_ns{};
  std::array<std::int64_t, kRoom> early_ns{};
  std::array<double, kRoom> late_mm{};
  std::array<double, kRoom> early_mm{};
  // Odd, so that the medians of times and positions belong to the same sample.
  const int third = std::max(0, used / 3 - 1) | 1;
  for (int i = 0; i < third; ++i) {
    const auto at = static_cast<std::size_t>(i);
    late_ns[at] = back(i).time_ns;
    late_mm[at] = back(i).position_mm;
    early_ns[at] = back(used - 1 - i).time_ns;
    early_mm[at] = back(used - 1 - i).position_mm;
  }
  const double way_mm = median(late_mm, third) - median(early_mm, third);
  return way_mm / (1e-9 * static_cast<double>(median(late_ns, third) - median(early_ns, third)));
}

}  // namespace tactus::haptics
