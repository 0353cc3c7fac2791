// A hand that the user moves with mouse or keyboard. Its wish follows a target smoothly.
#pragma once

#include <atomic>

#include "core/haptics/simulated/hand_plan.h"

namespace tactus::haptics {

/// Any thread may call the setters; the simulating thread calls `next`. Real-time safe: yes.
class LiveHand {
 public:
  /// Time constant and largest speed of the follower, both > 0.
  LiveHand(double time_constant_s, double largest_speed_mm_s) noexcept
      : time_constant_s_(time_constant_s), largest_speed_mm_s_(largest_speed_mm_s) {}

  /// Ignored if not finite.
  void setTarget(double position_mm) noexcept;
  void setButton(bool down) noexcept { button_.store(down, std::memory_order_relaxed); }

  /// Moves the follower to `position_mm` at once, at rest.
  void place(double position_mm) noexcept;
  /// The wish one millisecond later. Critically damped, without overshoot.
  HandWish next() noexcept;

 private:
  double time_constant_s_;
  double largest_speed_mm_s_;
  double position_mm_ = 0;
  double speed_mm_s_ = 0;
  std::atomic<double> target_mm_{0};
  std::atomic<bool> button_{false};
};

}  // namespace tactus::haptics
