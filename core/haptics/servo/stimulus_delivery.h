// Whether a stimulus reached the hand as it was ordered: a judgement counts only for a force that was delivered.
#pragma once

#include <cstdint>
#include <optional>

#include "core/haptics/servo/sample.h"

namespace tactus::haptics {

/// Follows one stimulus from its order to the answer. Delivered: it reached its full force, and until its time was over
/// or the hand let go, no stall, trip, stale device or silent program took it back, no cap and no thermal budget held
/// it down, and no sample was lost. The fade-in after arming ends before the full force is reached. Thread: the reader
/// of the samples. Real-time safe: yes.
class StimulusDelivery {
 public:
  /// The samples of one stimulus, all of them, oldest first.
  void add(const Sample& sample) noexcept;

  bool delivered() const noexcept { return full_ && limits_ == 0 && !lost_samples_; }
  /// The least share of the full force that was in the hand from the full force to the end of the stimulus, [0, 1].
  /// Nothing before the full force, or with lost samples.
  std::optional<double> leastShare() const noexcept;
  /// LimitBit: what kept the force from the hand.
  std::uint32_t limits() const noexcept { return limits_; }
  /// Ticks are missing between the samples: what was felt is not known.
  bool lostSamples() const noexcept { return lost_samples_; }

 private:
  std::optional<std::uint64_t> last_tick_;
  std::uint32_t limits_ = 0;
  double least_share_ = 1;  ///< from the full force on
  bool full_ = false;       ///< the full force was reached
  bool over_ = false;       ///< what follows belongs to the stimulus no more
  bool lost_samples_ = false;
};

}  // namespace tactus::haptics
