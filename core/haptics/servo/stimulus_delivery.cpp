#include "core/haptics/servo/stimulus_delivery.h"

namespace tactus::haptics {
namespace {

/// These take a force back that the hand felt already.
constexpr std::uint32_t kTakenBack = kLimitedByGap | kLimitedByTrip | kLimitedByStaleDevice | kLimitedByGui;
/// These hold the full force down.
constexpr std::uint32_t kHeldDown = kLimitedByCap | kLimitedByThermal;

}  // namespace

void StimulusDelivery::add(const Sample& sample) noexcept {
  if (over_) return;
  const bool begun = sample.stimulus != StimulusStage::kWaiting;
  if (begun && last_tick_ && sample.tick != *last_tick_ + 1) lost_samples_ = true;
  last_tick_ = sample.tick;
  if (!begun) return;
  limits_ |= sample.limited & kTakenBack;
  if (sample.stimulus == StimulusStage::kFull) {
    limits_ |= sample.limited & kHeldDown;
    full_ = full_ || (sample.limited & kLimitedByFadeIn) == 0;
  }
  over_ = sample.stimulus == StimulusStage::kFalling || sample.stimulus == StimulusStage::kEnded;
}

}  // namespace tactus::haptics
