#include "app/workbench/participant/force_trial.h"

#include <algorithm>

#include "app/session/judged_forces.h"

namespace tactus::workbench {

using haptics::StimulusPhase;

void ForceTrial::begin(const experiments::ForcePlan& plan) {
  plan_ = plan;
  felt_once_ = false;
  again_ = 0;
  delivered_before_ = true;
  share_before_ = 1;
  way_before_mm_ = speed_before_mm_s_ = since_full_s_ = 0;
  pause();
}

void ForceTrial::feelAgain() {
  if (phase_ != Phase::kFelt) return;
  const experiments::ForceAnswer before = measured();
  delivered_before_ = before.delivered;
  share_before_ = before.delivered_share;
  way_before_mm_ = before.forward_mm;
  speed_before_mm_s_ = before.forward_speed_mm_s;
  ++again_;
  pause();
}

void ForceTrial::cancel() {
  if (phase_ != Phase::kNone) device_.setForce({});
  phase_ = Phase::kNone;
}

void ForceTrial::pause() {
  device_.setForce({});
  phase_ = Phase::kPause;
  pause_since_ns_.reset();
  warm_ = restS() > plan_.pause_before_s;
}

// Without force from now on, until the motors can hold the whole force.
double ForceTrial::restS() const {
  experiments::ForcePlan at_once = plan_;
  at_once.pause_before_s = 0;
  return session::pauseBeforeS(at_once, device_.thermal(), device_.limits());
}

bool ForceTrial::add(std::span<const haptics::Sample> samples) {
  const Phase before = phase_;
  for (const haptics::Sample& sample : samples) {
    if (phase_ == Phase::kPause && !pause_since_ns_) pause_since_ns_ = sample.time_ns;
    if (phase_ == Phase::kWait || phase_ == Phase::kRise || phase_ == Phase::kFelt) take(sample);
  }
  if (phase_ == Phase::kPause && pause_since_ns_) {
    const double paused_s = static_cast<double>(samples.back().time_ns - *pause_since_ns_) * 1e-9;
    if (paused_s >= plan_.pause_before_s && restS() <= 0) order();
  }
  return phase_ != before;
}

void ForceTrial::order() {
  ForceOrders force;
  force.source = haptics::ForceSource::kStimulus;
  force.stimulus = {++number_, plan_.step.force_n, plan_.ramp_s, plan_.hold_limit_s, plan_.start_zone_mm};
  const auto orders = device_.setForce(force);
  if (!orders) return;  // the run has ended; another one begins with another trial
  orders_ = *orders;
  delivery_ = {};
  motion_.emplace(plan_.forward_least_mm_s);
  since_full_s_ = 0;
  phase_ = Phase::kWait;
}

void ForceTrial::take(const haptics::Sample& sample) {
  if (sample.orders < orders_) return;
  delivery_.add(sample);
  if (phase_ != Phase::kFelt) {
    const bool began = sample.stimulus != StimulusPhase::kWaiting;
    if (sample.since_full_s > 0 || sample.stimulus == StimulusPhase::kFull) {
      phase_ = Phase::kFelt;
      felt_once_ = true;
      full_ns_ = sample.time_ns;
    } else if (sample.stimulus == StimulusPhase::kEnded) {
      order();  // the hand let go too early: the same force waits for it again
      return;
    } else if (began) {
      phase_ = Phase::kRise;
    }
  }
  if (phase_ != Phase::kFelt) return;
  motion_->add({static_cast<double>(sample.time_ns - full_ns_) * 1e-9, sample.position_mm});
  since_full_s_ = sample.since_full_s;
}

experiments::ForceAnswer ForceTrial::measured() const {
  experiments::ForceAnswer out;
  const bool farther = motion_->wayMm() > way_before_mm_;
  out.forward_mm = farther ? motion_->wayMm() : way_before_mm_;
  out.forward_speed_mm_s = farther ? motion_->speedMmS() : speed_before_mm_s_;
  out.feel_again = again_;
  out.response_s = since_full_s_;
  out.delivered = delivered_before_ && delivery_.delivered();
  const auto share = delivery_.leastShare();
  out.delivered_share = share && share_before_ ? std::optional(std::min(*share, *share_before_)) : std::nullopt;
  return out;
}

}  // namespace tactus::workbench
