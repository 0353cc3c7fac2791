#include "core/haptics/simulated/live_hand.h"

#include <algorithm>
#include <cmath>

namespace tactus::haptics {

static_assert(std::atomic<double>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void LiveHand::setTarget(double position_mm) noexcept {
  if (std::isfinite(position_mm)) target_mm_.store(position_mm, std::memory_order_relaxed);
}

void LiveHand::place(double position_mm) noexcept {
  position_mm_ = position_mm;
  speed_mm_s_ = 0;
}

HandWish LiveHand::next() noexcept {
  constexpr double kTickS = 0.001;
  const double ahead_mm = target_mm_.load(std::memory_order_relaxed) - position_mm_;
  const double acceleration = (ahead_mm / time_constant_s_ - 2 * speed_mm_s_) / time_constant_s_;
  speed_mm_s_ = std::clamp(speed_mm_s_ + kTickS * acceleration, -largest_speed_mm_s_, largest_speed_mm_s_);
  position_mm_ += kTickS * speed_mm_s_;
  return {position_mm_, speed_mm_s_, true, button_.load(std::memory_order_relaxed)};
}

}  // namespace tactus::haptics
