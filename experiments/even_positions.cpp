#include "experiments/even_positions.h"

#include "core/base/check.h"

namespace tactus::experiments {

void EvenPositions::add(const PositionSample& sample) {
  TACTUS_CHECK(sample.time_s > last_.time_s);
  const double slope = (sample.position_mm - last_.position_mm) / (sample.time_s - last_.time_s);
  for (;; ++fine_count_) {
    const double time_s = start_s_ + static_cast<double>(fine_count_) * kFineS;
    if (time_s > sample.time_s) break;
    block_sum_mm_ += last_.position_mm + slope * (time_s - last_.time_s);
    if (++block_size_ == kBlock) {
      positions_mm_.push_back(block_sum_mm_ / kBlock);
      block_sum_mm_ = 0;
      block_size_ = 0;
    }
  }
  last_ = sample;
}

void EvenPositions::forgetBefore(std::size_t step) {
  while (first_ < step && !positions_mm_.empty()) {
    positions_mm_.pop_front();
    ++first_;
  }
}

}  // namespace tactus::experiments
