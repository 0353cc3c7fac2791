#include "app/workbench/participant/participant_course.h"

#include <algorithm>
#include <cmath>

#include "app/session/judged_forces.h"
#include "experiments/force_series.h"

namespace tactus::workbench {

bool DeviceCheck::add(std::span<const haptics::Sample> samples) {
  const DeviceStep before = step_;
  for (const haptics::Sample& sample : samples) onSample(sample);
  return step_ != before;
}

void DeviceCheck::onSample(const haptics::Sample& sample) {
  const bool holds = sample.enabled;
  seen_open_ = seen_open_ || !holds;
  switch (step_) {
    case DeviceStep::kHold:
      if (holds && seen_open_) {
        step_ = DeviceStep::kStill;
        rest(sample);
      }
      break;
    case DeviceStep::kStill:
      if (!holds) {
        step_ = DeviceStep::kHold;
      } else if (std::abs(sample.position_mm - at_mm_) > kStillMm) {
        rest(sample);
      } else if (static_cast<double>(sample.time_ns - still_since_ns_) * 1e-9 >= kStillS) {
        step_ = DeviceStep::kPush;
        at_mm_ = sample.position_mm;
      }
      break;
    case DeviceStep::kPush:
      if (!holds) {
        step_ = DeviceStep::kHold;
      } else if (sample.position_mm - at_mm_ >= kPushMm) {
        step_ = DeviceStep::kRelease;
      }
      break;
    case DeviceStep::kRelease:
      if (!holds) step_ = DeviceStep::kReady;
      break;
    default: break;
  }
}

// The hand is still from here on, as far as is known.
void DeviceCheck::rest(const haptics::Sample& sample) {
  still_since_ns_ = sample.time_ns;
  at_mm_ = sample.position_mm;
}

bool HoldClock::add(std::span<const haptics::Sample> samples, bool asks, WaitsFor what) {
  const HoldWait before = wait_;
  for (const haptics::Sample& sample : samples) {
    if (!asks || (sample.enabled && what == WaitsFor::kHold)) {
      begin();
      continue;
    }
    if (!since_ns_) since_ns_ = sample.time_ns;
    const double waited_s = static_cast<double>(sample.time_ns - *since_ns_) * 1e-9;
    wait_ = waited_s >= kStuckS ? HoldWait::kStuck : waited_s >= kHintS ? HoldWait::kHint : HoldWait::kNot;
  }
  return wait_ != before;
}

using haptics::StimulusPhase;

void ForceTrial::begin(const experiments::ForcePlan& plan) {
  plan_ = plan;
  pushed_ = repeated_ = false;
  again_ = 0;
  delivered_before_ = true;
  share_before_ = 1;
  way_before_mm_ = speed_before_mm_s_ = since_full_s_ = 0;
  pause();
}

void ForceTrial::feelAgain() {
  if (!wasPushed()) return;
  keepWay();
  ++again_;
  pause();
}

void ForceTrial::keepWay() {
  const experiments::ForceAnswer before = measured();
  delivered_before_ = before.delivered;
  share_before_ = before.delivered_share;
  way_before_mm_ = before.forward_mm;
  speed_before_mm_s_ = before.forward_speed_mm_s;
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
  const bool pushed_before = pushed_;
  for (const haptics::Sample& sample : samples) {
    if (phase_ == Phase::kPause && !pause_since_ns_) pause_since_ns_ = sample.time_ns;
    if (phase_ == Phase::kWait || phase_ == Phase::kRise || phase_ == Phase::kFelt) onSample(sample);
  }
  if (phase_ == Phase::kPause && pause_since_ns_) {
    const double paused_s = static_cast<double>(samples.back().time_ns - *pause_since_ns_) * 1e-9;
    if (paused_s >= plan_.pause_before_s && restS() <= 0) order();
  }
  return phase_ != before || pushed_ != pushed_before;
}

void ForceTrial::order() {
  ForceOrders force;
  force.source = haptics::ForceSource::kStimulus;
  force.scale = plan_.device_scale;
  force.stimulus = {++number_, plan_.step.force_n, plan_.ramp_s, plan_.hold_limit_s, plan_.start_zone_mm};
  const auto orders = device_.setForce(force);
  if (!orders) return;  // the run has ended; another one begins with another trial
  orders_ = *orders;
  delivery_ = {};
  motion_.emplace(plan_.forward_least_mm_s);
  since_full_s_ = 0;
  phase_ = Phase::kWait;
}

void ForceTrial::onSample(const haptics::Sample& sample) {
  if (sample.orders < orders_) return;
  delivery_.add(sample);
  if (phase_ != Phase::kFelt) {
    const bool began = sample.stimulus != StimulusPhase::kWaiting;
    if (sample.since_full_s > 0 || sample.stimulus == StimulusPhase::kFull) {
      phase_ = Phase::kFelt;
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
  const bool enough = motion_->wayMm() >= plan_.forward_least_mm && motion_->speedMmS() >= plan_.forward_least_mm_s;
  pushed_ = pushed_ || enough;
  if (pushed_ || sample.stimulus != StimulusPhase::kEnded) return;
  repeated_ = true;
  pause();
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

namespace {

using session::Block;
using session::SessionPart;

ParticipantScreen withDevice(const CoursePassed& passed, ParticipantScreen screen) {
  return passed.device ? screen : ParticipantScreen::kDeviceCheck;
}

ParticipantScreen formScreen(const SessionSnapshot& at, const CoursePassed& passed) {
  if (!passed.glossary) return ParticipantScreen::kGlossary;
  return at.page ? ParticipantScreen::kQuestion : ParticipantScreen::kReview;
}

/// The practice of the forces is over, and the first one that counts comes.
bool beginsToCount(const SessionSnapshot& at) {
  const experiments::ForceSettings& settings = at.settings->force;
  const std::string first = settings.ascending ? experiments::kAscending : experiments::kRandom;
  const auto& step = at.force->step;
  return !settings.familiarisation_n.empty() && step.series == first && step.step == 1 && at.force->attempt == 1;
}

}  // namespace

std::string restBefore(const SessionSnapshot& at, const CoursePassed& passed) {
  const bool in_block =
      at.part == SessionPart::kSpeed || at.part == SessionPart::kForce || at.part == SessionPart::kForm;
  if (in_block && at.blocks_done > passed.blocks) {
    const std::string between = "before_" + std::string(name(*at.block));
    if (!passed.rests.contains(between)) return between;
  }
  if (at.part == SessionPart::kForce && beginsToCount(at) && !passed.rests.contains(kBeginsToCount)) {
    return kBeginsToCount;
  }
  if (at.part == SessionPart::kForce && at.force->question.rest_first) {
    const auto& step = at.force->step;
    const std::string long_rest =
        step.series + ' ' + std::to_string(step.step) + ' ' + std::to_string(at.force->attempt);
    if (!passed.rests.contains(long_rest)) return long_rest;
  }
  const bool next_question = at.part == SessionPart::kForm && at.page && !at.page->reply;
  const bool due = next_question && passed.replies > 0 && (at.page->position - 1) % kQuestionsToRest == 0;
  if (!due) return {};
  const std::string before_question = "question_" + std::to_string(at.page->position);
  return passed.rests.contains(before_question) ? std::string() : before_question;
}

bool isUsability(const SessionSnapshot& at) { return at.record && at.record->kind == study::SessionKind::kUsability; }

ParticipantScreen screenOf(const SessionSnapshot* at, const CoursePassed& passed) {
  if (passed.stopped) return ParticipantScreen::kStopped;
  if (at == nullptr) return passed.code ? ParticipantScreen::kConsent : ParticipantScreen::kWelcome;
  if (at->part == SessionPart::kAborted) return ParticipantScreen::kStopped;
  if (isUsability(*at)) {
    return at->part == SessionPart::kFinished ? ParticipantScreen::kThanks : ParticipantScreen::kScale;
  }
  if (!restBefore(*at, passed).empty()) return ParticipantScreen::kRest;
  switch (at->part) {
    case SessionPart::kProfile: return ParticipantScreen::kAboutYou;
    case SessionPart::kSpeed:
      return withDevice(passed, at->speed->practice ? ParticipantScreen::kPractice : ParticipantScreen::kSpeed);
    case SessionPart::kForce: {
      const bool practice = at->force->step.series == experiments::kFamiliarisation;
      return withDevice(passed, practice ? ParticipantScreen::kPractice : ParticipantScreen::kForce);
    }
    case SessionPart::kForm: return formScreen(*at, passed);
    case SessionPart::kRating:
      return at->block == Block::kForm && !passed.sealing ? ParticipantScreen::kReview : ParticipantScreen::kRating;
    case SessionPart::kFinished:
      if (at->form && !passed.sealed) return ParticipantScreen::kReview;
      return passed.own_model ? ParticipantScreen::kThanks : withDevice(passed, ParticipantScreen::kOwnModel);
    case SessionPart::kAborted: break;
  }
  return ParticipantScreen::kStopped;
}

}  // namespace tactus::workbench
