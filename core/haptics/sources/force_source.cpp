#include "core/haptics/sources/force_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/render/insertion_renderer.h"

namespace tactus::haptics {
namespace {

/// Additions of ticks miss a time by less than this.
constexpr double kRoundingS = 1e-9;

/// Time at the full force; above the continuous rating no longer than the limits allow.
double holdLimitS(const Stimulus& stimulus, double scale, const LimitSettings& limits) noexcept {
  const double asked_s = stimulus.hold_limit_s.value_or(std::numeric_limits<double>::infinity());
  return stimulus.force_n / scale > limits.continuous_force_n ? std::min(asked_s, limits.stimulus_hold_s) : asked_s;
}

/// Share of the ramp in one tick; a ramp without length is a step, which the slew limit takes.
double stepOfRamp(const Stimulus& stimulus, double dt_s) noexcept {
  return stimulus.ramp_s > 0 ? dt_s / stimulus.ramp_s : 1;
}

}  // namespace

double StimulusSource::tick(const StimulusTick& tick, const Stimulus& stimulus, const LimitSettings& limits) noexcept {
  if (stimulus_.number != stimulus.number) {
    letGo();
    phase_ = StimulusPhase::kWaiting;
    full_ = false;
    since_full_s_ = 0;
  } else if (full_) {
    since_full_s_ += tick.dt_s;
  }
  const bool begun = phase_ != StimulusPhase::kWaiting;
  if (!begun) stimulus_ = stimulus;
  if (begun && phase_ != StimulusPhase::kEnded && !(tick.active && tick.enabled)) {
    letGo();
    phase_ = StimulusPhase::kEnded;
  }
  if (tick.active) advance(tick, limits);

  const double step_n = fading_n_s_ * tick.dt_s;
  fading_n_ = std::abs(fading_n_) > step_n ? fading_n_ - std::copysign(step_n, fading_n_) : 0;
  force_n_ = (level_ > 0 ? level_ * stimulus_.force_n : 0) + fading_n_;
  return force_n_;
}

/// What is felt now fades, no slower than what fades already; a stimulus that follows begins from nothing beside it.
void StimulusSource::letGo() noexcept {
  const double running_n_s = fading_n_ != 0 ? fading_n_s_ : 0;
  fading_n_ = std::isfinite(force_n_) ? force_n_ : 0;
  fading_n_s_ = std::max(running_n_s, std::abs(fading_n_) / render::kReleaseFadeS);
  level_ = 0;
}

void StimulusSource::advance(const StimulusTick& tick, const LimitSettings& limits) noexcept {
  const bool in_zone = !stimulus_.start_zone_mm || std::abs(tick.position_mm) <= *stimulus_.start_zone_mm;
  if (phase_ == StimulusPhase::kWaiting && tick.enabled && in_zone) phase_ = StimulusPhase::kRising;
  if (phase_ == StimulusPhase::kRising) {
    level_ = std::min(1.0, level_ + stepOfRamp(stimulus_, tick.dt_s));
    if (level_ > 1 - kRoundingS) {
      level_ = 1;
      full_ = true;
      phase_ = StimulusPhase::kFull;
    }
  } else if (phase_ == StimulusPhase::kFull && since_full_s_ > holdLimitS(stimulus_, tick.scale, limits) - kRoundingS) {
    phase_ = StimulusPhase::kFalling;
  }
  if (phase_ == StimulusPhase::kFalling) {
    level_ = std::max(0.0, level_ - stepOfRamp(stimulus_, tick.dt_s));
    if (level_ < kRoundingS) {
      level_ = 0;
      phase_ = StimulusPhase::kEnded;
    }
  }
}

}  // namespace tactus::haptics
