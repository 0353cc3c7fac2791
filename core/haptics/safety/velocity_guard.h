// Detects a hand that is too fast for the insertion of a tube: it has slipped, or a force drives it.
#pragma once

#include <array>
#include <cstdint>

#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/safety/trip.h"

namespace tactus::haptics {

/// The speed is the slope of Tukey's resistant line (Exploratory Data Analysis, 1977) through the samples of the last
/// 15 ms: it joins the medians of the first and the last third. One count of 0.055 mm within 1 ms is 55 mm/s for a
/// plain difference and at most 5.5 mm/s here. A single wrong sample has no effect. A dropped tick or a stall counts as
/// elapsed time only.
/// Plain state. Thread: servo. Real-time safe: yes.
class VelocityGuard {
 public:
  /// Adds one sample of the device. `number`: its number. `time_ns`: its arrival time. A repeated sample is ignored. If
  /// its arrival time is renewed by 15 ms or more (a device that is silent at rest), the hand rests and the speed is 0.
  /// A stall renews nothing, so the next sample gives the mean speed since the last one.
  void add(std::uint64_t number, std::int64_t time_ns, double position_mm) noexcept;
  /// Speed, mm/s, positive inwards, about 5 ms late. 0 until the samples span 8 ms.
  double speedMmS() const noexcept { return speed_mm_s_; }
  /// The trip that this speed requires, or none. The caller sets `time_ns`.
  Trip check(const LimitSettings& limits) const noexcept;
  /// Forgets all samples, because positions have a new meaning.
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
