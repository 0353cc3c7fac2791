// Detects a loop that has stopped calling the servo.
#pragma once

#include <cstdint>

#include "core/haptics/safety/trip.h"

namespace tactus::haptics {

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

}  // namespace tactus::haptics
