#include "core/haptics/servo/stimulus_delivery.h"

#include <algorithm>

namespace tactus::haptics {
namespace {

/// These take a force back that the hand felt already.
constexpr std::uint32_t kTakenBack = kLimitedByGap | kLimitedByTrip | kLimitedByStaleDevice | kLimitedByGui;
/// These hold the full force down.
constexpr std::uint32_t kHeldDown = kLimitedByCap | kLimitedByThermal;

/// A blank asks for no force, and all of it is delivered.
double shareOf(const Sample& sample) noexcept {
  if (sample.source_force_n <= 0) return 1;
  return std::clamp(sample.force_n / sample.source_force_n, 0.0, 1.0);
}

}  // namespace

std::optional<double> StimulusDelivery::leastShare() const noexcept {
  if (!full_ || lost_samples_) return std::nullopt;
  return least_share_;
}

void StimulusDelivery::add(const Sample& sample) noexcept {
  if (over_) return;
  const bool begun = sample.stimulus != StimulusPhase::kWaiting;
  if (begun && last_tick_ && sample.tick != *last_tick_ + 1) lost_samples_ = true;
  last_tick_ = sample.tick;
  if (!begun) return;
  limits_ |= sample.limited & kTakenBack;
  if (sample.stimulus == StimulusPhase::kFull) {
    limits_ |= sample.limited & kHeldDown;
    full_ = full_ || (sample.limited & kLimitedByFadeIn) == 0;
    if (full_) least_share_ = std::min(least_share_, shareOf(sample));
  } else if (full_ && (sample.limited & kTakenBack) != 0) {
    least_share_ = 0;
  }
  over_ = sample.stimulus == StimulusPhase::kFalling || sample.stimulus == StimulusPhase::kEnded;
}

}  // namespace tactus::haptics
