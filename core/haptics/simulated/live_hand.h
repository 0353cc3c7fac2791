// A hand that a person moves with mouse or keyboard: the wish follows a target smoothly.
#pragma once

#include <atomic>

#include "core/haptics/simulated/hand_plan.h"

namespace tactus::haptics {

/// The setters belong to any thread, `next` to the one that simulates. Real-time safe: yes.
class LiveHand {
 public:
  /// Both > 0: time constant of the follower, and its largest speed.
  LiveHand(double time_constant_s, double largest_speed_mm_s) noexcept
      : time_constant_s_(time_constant_s), largest_speed_mm_s_(largest_speed_mm_s) {}

  /// Not finite: ignored.
  void setTarget(double position_mm) noexcept;
  void setButton(bool down) noexcept { button_.store(down, std::memory_order_relaxed); }

  /// The follower jumps to `position_mm` and rests.
  void place(double position_mm) noexcept;
  /// The wish one millisecond later: critically damped, without overshoot.
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
