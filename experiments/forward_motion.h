// Measures the distance and speed of forward motion during a force.
#pragma once

#include <cstddef>

#include "experiments/even_positions.h"

namespace tactus::experiments {

/// Forward travel, and the mean speed over it. Time is divided into blocks of 0.1 s. A block counts if the hand moved
/// forward at `least_mm_s` or faster. Tremor of 0.3 mm moves a resting hand by less than 0.6 mm per block, so it does
/// not count at the default of 10 mm/s. Add the samples from the full force to the answer; pauses and returns between
/// do no harm.
class ForwardMotion {
 public:
  explicit ForwardMotion(double least_mm_s) : least_mm_s_(least_mm_s) {}

  /// Adds a sample. Ignores a sample that is not finite or whose time does not rise.
  void add(const PositionSample& sample);

  double wayMm() const noexcept { return way_mm_; }
  /// Mean speed over the forward travel; 0 without travel.
  double speedMmS() const noexcept { return moving_s_ > 0 ? way_mm_ / moving_s_ : 0; }

 private:
  static constexpr double kBlockS = 0.1;

  double least_mm_s_;
  bool started_ = false;
  PositionSample block_start_;
  PositionSample last_;
  double way_mm_ = 0;
  double moving_s_ = 0;
};

}  // namespace tactus::experiments
