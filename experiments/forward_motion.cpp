#include "experiments/forward_motion.h"

#include <cmath>

namespace tactus::experiments {

void ForwardMotion::add(const PositionSample& sample) {
  if (!std::isfinite(sample.time_s) || !std::isfinite(sample.position_mm)) return;
  if (!started_) {
    started_ = true;
    block_start_ = sample;
    last_ = sample;
    return;
  }
  if (sample.time_s <= last_.time_s) return;
  last_ = sample;
  constexpr double kRoundingS = 1e-9;  // time stamps are sums of steps
  const double length_s = sample.time_s - block_start_.time_s;
  if (length_s < kBlockS - kRoundingS) return;
  const double forward_mm = sample.position_mm - block_start_.position_mm;
  if (forward_mm >= least_mm_s_ * length_s) {
    way_mm_ += forward_mm;
    moving_s_ += length_s;
  }
  block_start_ = sample;
}

}  // namespace tactus::experiments
