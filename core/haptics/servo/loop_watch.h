// Notices a loop that has stopped calling the servo.
#pragma once

#include <cstdint>

#include "core/haptics/safety/trip.h"

namespace tactus::haptics {

/// A driver whose loop stops says nothing, and a servo that is not called cannot trip. Whoever looks at the servo now
/// and then, 60 times a second or so, asks here. A pause between two looks counts for 0.1 s at most: a program that
/// stood still as a whole gives its loop time to go on.
class LoopWatch {
 public:
  static constexpr double kSilentS = 1;  ///< without a tick for so long, the loop is gone

  /// `ticks` as Servo::ticks has it, `now_ns` on a monotonic clock. The trip that this calls for: kServoLate, or none.
  Trip look(std::uint64_t ticks, std::int64_t now_ns) noexcept;

 private:
  bool looked_ = false;
  std::uint64_t ticks_ = 0;
  std::int64_t last_ns_ = 0;
  double silent_s_ = 0;
};

}  // namespace tactus::haptics
