// Detects forward and backward movements in resampled positions with tremor and noise. Its edges are coarse.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "experiments/even_positions.h"
#include "experiments/stroke.h"

namespace tactus::experiments {

/// A movement, in steps of EvenPositions.
struct Movement {
  std::size_t begin = 0;
  std::size_t fast_from = 0;  ///< first and last step at the starting speed or above
  std::size_t fast_to = 0;
  std::size_t end = 0;
  bool forward = true;
  bool interrupted = false;  ///< the positions ended during the movement
};

/// The two-threshold rule of stroke_segmentation.h, applied to one stretch without gaps.
class MovementDetector {
 public:
  /// `lowest_been_mm`: the furthest-back position of the hand in earlier stretches.
  MovementDetector(const StrokeSettings& settings, double lowest_been_mm);

  /// Processes all steps with enough positions after them; all steps if the stretch has `ended`.
  void advance(const EvenPositions& positions, bool ended);
  /// The next completed movement, or nothing.
  std::optional<Movement> take();

  bool movingForward() const noexcept { return phase_ == Phase::kMoving; }
  double lowestBeenMm() const noexcept { return lowest_been_mm_; }
  /// Positions before this step are no longer needed, except to measure movements already taken.
  std::size_t earliestNeeded() const noexcept;
  void forgetBefore(std::size_t step);

 private:
  enum class Phase { kIdle, kMoving, kPausing };

  double slopeAt(const EvenPositions& positions, std::size_t step) const;
  double speedAt(std::size_t step) const { return speeds_mm_s_[step - first_]; }
  std::size_t quietBefore(std::size_t step, double direction) const;
  void lookForward(std::size_t step, double position_mm, double speed_mm_s);
  void lookBack(std::size_t step, double position_mm, double speed_mm_s);
  void close(std::size_t end, double length_mm, bool interrupted);

  StrokeSettings settings_;
  std::size_t half_window_;
  std::size_t pause_steps_;
  std::deque<double> speeds_mm_s_;
  std::size_t first_ = 0;
  std::size_t decided_ = 0;

  Phase phase_ = Phase::kIdle;
  Movement forward_;
  double begin_mm_ = 0;
  double furthest_mm_ = 0;
  std::size_t paused_at_ = 0;

  std::optional<Movement> back_;
  double lowest_been_mm_;
  std::deque<Movement> found_;
};

}  // namespace tactus::experiments
