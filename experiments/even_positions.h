// Resamples positions with arbitrary times to equal steps.
#pragma once

#include <cstddef>
#include <deque>

namespace tactus::experiments {

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

}  // namespace tactus::experiments
