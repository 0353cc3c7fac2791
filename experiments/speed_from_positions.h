// The speed of a recorded motion, offline from its positions.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/error.h"

namespace tactus::experiments {

/// Rate of the speeds, Hz: that of the servo.
inline constexpr double kSpeedRateHz = 1000;
/// Window of the derivative in samples at kSpeedRateHz (31 ms). White noise of 1 mm in the positions becomes 20.1 mm/s
/// of speed, and a motion of 10 Hz keeps 91 % of its speed; a longer window lowers both.
inline constexpr std::size_t kDerivativeWindow = 31;
/// Steps between time stamps above this are gaps: a third of the window, ten ticks of the servo.
inline constexpr double kLongestStepS = 0.010;
/// Below this a hand counts as resting, mm/s: just above what quantised positions (0.055 mm) can turn rest into, 2.7
/// mm/s. A hand that trembles at rest is faster (0.1 mm at 10 Hz: 6 mm/s); where a recording holds such rest, ask for
/// more.
inline constexpr double kRestSpeedMmS = 3;

struct MotionSample {
  double time_s = 0;
  double depth_mm = 0;
  double speed_mm_s = 0;

  bool operator==(const MotionSample&) const = default;
};

/// A stretch without positions that is longer than kLongestStepS. The motion is interpolated across it all the same.
struct PositionGap {
  double from_s = 0;
  double to_s = 0;

  bool operator==(const PositionGap&) const = default;
};

struct Motion {
  std::vector<MotionSample> samples;  ///< every 1 / kSpeedRateHz from the first time stamp on, not beyond the last
  std::vector<PositionGap> gaps;
};

/// Depth by linear interpolation at 1 kHz, speed as its zero-phase derivative: the slope in the middle of a parabola
/// fitted to a window of 31 samples (Savitzky and Golay 1964, order 2). In the first and last 15 samples the parabola
/// of the window at that edge is used, of all samples where there are fewer than 31. Exact for motions that are
/// parabolas in time. `time_s` and `depth_mm` belong together one by one. Refused, with the position from 1: a number
/// that is not finite, a time that does not rise; further, another number of times than depths, fewer than three
/// samples at 1 kHz, more than ten hours. Thread: any. Real-time safe: no.
base::Result<Motion> speedFromPositions(std::span<const double> time_s, std::span<const double> depth_mm);

/// The part from the first to the last sample that is faster than `above_mm_s`, forward: the stroke without the rest
/// before and after it. Slow and backward samples in between stay. Empty where no sample is faster.
std::span<const MotionSample> forwardPart(std::span<const MotionSample> samples, double above_mm_s = kRestSpeedMmS);

}  // namespace tactus::experiments
