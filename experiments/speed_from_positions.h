// The speed of a recorded motion, computed offline from its positions.
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "core/base/error.h"

namespace tactus::experiments {

// Resamples positions with arbitrary times to equal steps.

/// One position along the insertion axis, forward positive.
struct PositionSample {
  double time_s = 0;
  double position_mm = 0;
};

/// A stretch of samples without a gap, resampled to 250 Hz: linear interpolation to 1 kHz, then means of four.
class EvenPositions {
 public:
  static constexpr double kStepS = 0.004;

  explicit EvenPositions(const PositionSample& first) : start_s_(first.time_s), last_(first) {}

  /// Adds the next sample. Its time must be later than the previous one's.
  void add(const PositionSample& sample);
  double lastTimeS() const noexcept { return last_.time_s; }

  /// Number of steps so far, including forgotten ones.
  std::size_t size() const noexcept { return first_ + positions_mm_.size(); }
  std::size_t first() const noexcept { return first_; }  ///< first step not forgotten
  double at(std::size_t step) const { return positions_mm_[step - first_]; }
  double timeS(double step) const noexcept { return start_s_ + 1.5 * kFineS + step * kStepS; }

  void forgetBefore(std::size_t step);

 private:
  static constexpr double kFineS = 0.001;
  static constexpr int kBlock = 4;

  double start_s_;
  PositionSample last_;
  std::size_t fine_count_ = 0;
  double block_sum_mm_ = 0;
  int block_size_ = 0;
  std::deque<double> positions_mm_;
  std::size_t first_ = 0;
};

/// Rate of the speeds, Hz: the rate of the servo.
inline constexpr double kSpeedRateHz = 1000;
/// Window of the derivative in samples at kSpeedRateHz (31 ms). White noise of 1 mm in the positions gives 20.1 mm/s in
/// the speed, and a motion of 10 Hz keeps 91 % of its speed. A longer window lowers both.
inline constexpr std::size_t kDerivativeWindow = 31;
/// A larger step between time stamps is a gap: a third of the window, ten ticks of the servo.
inline constexpr double kLongestStepS = 0.010;
/// Below this speed the hand counts as resting, mm/s. Just above the 2.7 mm/s that quantization (0.055 mm) can produce
/// at rest. A trembling hand at rest is faster (0.1 mm at 10 Hz: 6 mm/s); for such recordings, choose a larger value.
inline constexpr double kRestSpeedMmS = 3;

struct MotionSample {
  double time_s = 0;
  double depth_mm = 0;
  double speed_mm_s = 0;

  bool operator==(const MotionSample&) const = default;
};

/// An interval longer than kLongestStepS without positions. The motion is interpolated across it.
struct PositionGap {
  double from_s = 0;
  double to_s = 0;

  bool operator==(const PositionGap&) const = default;
};

struct Motion {
  std::vector<MotionSample> samples;  ///< every 1 / kSpeedRateHz from the first time stamp to the last
  std::vector<PositionGap> gaps;
};

/// Depth by linear interpolation at 1 kHz. Speed as its zero-phase derivative: the slope in the middle of a parabola
/// fitted to a window of 31 samples (Savitzky and Golay 1964, order 2). The first and last 15 samples use the parabola
/// of the window at that edge; with fewer than 31 samples, one parabola covers all. Exact for motions that are
/// parabolas in time.
/// `time_s` and `depth_mm`: of equal length. Returns an error with the position (from 1) of a number that is not finite
/// or a time that does not rise. Also for: different lengths, fewer than three samples at 1 kHz, more than ten hours.
/// Thread: any. Real-time safe: no.
base::Result<Motion> speedFromPositions(std::span<const double> time_s, std::span<const double> depth_mm);

/// The part from the first to the last sample with a forward speed above `above_mm_s`: the stroke without the rest
/// before and after. Slow and backward samples between stay. Empty if no sample is faster.
std::span<const MotionSample> forwardPart(std::span<const MotionSample> samples, double above_mm_s = kRestSpeedMmS);

}  // namespace tactus::experiments
