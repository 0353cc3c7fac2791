// Whether the hand moves faster than anybody inserts a tube: it has slipped, or a force drives it.
#pragma once

#include <array>
#include <cstdint>

#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/safety/trip.h"

namespace tactus::haptics {

/// Speed is Tukey's resistant line (Exploratory Data Analysis, 1977) through the samples of the last 15 ms: the medians
/// of its first and last third, joined. One count of 0.055 mm within 1 ms is 55 mm/s to a plain difference and at
/// most 5.5 mm/s here; a sample that is wrong does not count, a dropped tick or a stall is only time that passed. Plain
/// state. Thread: servo. Real-time safe: yes.
class VelocityGuard {
 public:
  /// One sample of the device. `number`: its number; `time_ns`: when it arrived. The same sample again is ignored, but
  /// where it was renewed 15 ms later or more (HapticDevice, silent when still) the hand rests: the speed is 0. A stall
  /// renews nothing, so the next sample gives the mean speed since the last one.
  void add(std::uint64_t number, std::int64_t time_ns, double position_mm) noexcept;
  /// Inwards positive, about 5 ms late; 0 until the samples span 8 ms.
  double speedMmS() const noexcept { return speed_mm_s_; }
  /// The trip that this speed calls for, if any; `time_ns` is left to the caller.
  Trip check(const LimitSettings& limits) const noexcept;
  /// Positions mean something else from now on.
  void forget() noexcept { *this = {}; }

 private:
  struct Point {
    std::int64_t time_ns = 0;
    double position_mm = 0;
  };
  static constexpr int kRoom = 32;  ///< 15 ms of samples that are at least 0.5 ms apart

  const Point& back(int steps) const noexcept { return points_[static_cast<std::size_t>(newest_ - steps) % kRoom]; }
  double fitted() const noexcept;

  std::array<Point, kRoom> points_{};
  std::uint64_t number_ = 0;
  int count_ = 0;
  int newest_ = 0;
  double speed_mm_s_ = 0;
};

}  // namespace tactus::haptics
