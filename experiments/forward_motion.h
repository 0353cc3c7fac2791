// How far and how fast a hand moved forward while it felt a force.
#pragma once

#include <cstddef>

#include "experiments/even_positions.h"

namespace tactus::experiments {

/// Way forward and mean speed on it. Time is cut into blocks of 0.1 s; a block counts if the hand got forward in it at
/// `least_mm_s` or faster. Tremor of 0.3 mm moves a resting hand by less than 0.6 mm a block, so at the default of
/// 10 mm/s it is no way. Feed it from the full force to the answer; pauses and returns in between do no harm.
class ForwardMotion {
 public:
  explicit ForwardMotion(double least_mm_s) : least_mm_s_(least_mm_s) {}

  /// A sample whose time does not rise or that is not finite is left out.
  void add(const PositionSample& sample);

  double wayMm() const noexcept { return way_mm_; }
  /// Mean speed on the way; 0 where there was none.
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
