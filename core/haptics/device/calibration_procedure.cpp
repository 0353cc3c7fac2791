#include "core/haptics/device/calibration_procedure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/base/text.h"
#include "core/haptics/device/device.h"

namespace tactus::haptics {
namespace {

using Step = CalibrationStep;

constexpr double kRestS = 0.5;
constexpr double kLeastRate = 100;       // samples per second below which a resting device counts as silent
constexpr double kLeastThreshold = 4;    // counts
constexpr double kRestlessCounts = 200;  // a hand is on it, or it drifts
constexpr double kSignWatchS = 0.2;      // from the beginning of a push
constexpr double kSettleS = 0.3;
constexpr double kSlipMm = 15;
constexpr double kRampS = 0.5;
constexpr double kAligned = 0.9998;  // cosine of 1 degree: no hand holds a scale better
constexpr double kLongestHoldS = 60;
constexpr double kOldestS = 0.2;  // a position or a force that is older says nothing of this moment
constexpr std::array kAxisNames = {"x", "y", "z"};
constexpr std::array kAxisWords = {"x (left and right)", "y (up and down)", "z (toward you and away)"};

double length(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

std::array<double, 3> difference(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double& component(Vector3& v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

std::string percent(double share) { return base::formatFixed(share * 100, 0) + " %"; }

std::string degrees(double cosine) {
  return base::formatFixed(std::acos(std::clamp(cosine, 0.0, 1.0)) * 180 / std::numbers::pi, 0) + " degrees";
}

std::string motorWords(const DrivenAxes& driven) {
  std::vector<std::string> words;
  for (std::size_t axis = 0; axis < driven.size(); ++axis) {
    if (driven[axis]) words.emplace_back(kAxisWords[axis]);
  }
  return base::joined(words, " and ");
}

}  // namespace

CalibrationPlan planFor(const DeviceInfo& info) {
  CalibrationPlan plan;
  plan.device = info.id;
  plan.serial = info.serial;
  plan.driven = drivenAxes(info.force_axes);
  return plan;
}

CalibrationProcedure::CalibrationProcedure(CalibrationPlan plan) : plan_(std::move(plan)) {
  TACTUS_CHECK(plan_.driven[0] || plan_.driven[1] || plan_.driven[2]);
  go(Step::kLetGo);
}

CalibrationInput CalibrationProcedure::wanted() const {
  switch (step_) {
    case Step::kLetGo:
    case Step::kOuterEnd:
    case Step::kInnerEnd:
    case Step::kLetGoAgain:
    case Step::kScaleReady: return CalibrationInput::kContinue;
    case Step::kRuler:
    case Step::kWeight:
    case Step::kScaleLow:
    case Step::kScaleHigh: return CalibrationInput::kNumber;
    default: return CalibrationInput::kNothing;
  }
}

void CalibrationProcedure::go(Step step) {
  step_ = step;
  just_entered_ = true;
  switch (step) {
    case Step::kLetGo: return say("Put the handle in the middle, let go of it and keep clear. Then continue.");
    case Step::kRest: return say("Do not touch the handle.");
    case Step::kSign: return say("Do not touch the handle: it will twitch.");
    case Step::kOuterEnd:
      return say("Lay a ruler beside the handle. Hold the handle where the tube begins. Then continue.");
    case Step::kInnerEnd:
      return say("Move the handle along the ruler, the way the tube goes in, and hold it there. Then continue.");
    case Step::kRuler: return say("Type how far the handle moved on the ruler, in mm.");
    case Step::kLetGoAgain:
      return say("Put the handle in the middle, let go of it and keep clear: it will be pushed slowly. Then continue.");
    case Step::kFrictionIn: return say("Do not touch the handle: the push inwards rises until it moves.");
    case Step::kFrictionOut: return say("Do not touch the handle: the push outwards rises until it moves.");
    case Step::kWeight:
      return say("Hang a weight so that it pulls the handle inwards, " + scaleDirection() +
                 ". Type the weight in N (1 kg is 9.81 N).");
    case Step::kLift: return say("Do not touch the handle: the push outwards rises until the weight moves.");
    case Step::kScaleReady:
      return say("Hold the handle back with a spring scale that pulls inwards, " + scaleDirection() +
                 ", so that it cannot move outwards. Then continue.");
    case Step::kScaleLow: return say("The handle pushes outwards. Type what the spring scale reads, in N.");
    case Step::kScaleHigh: return say("The push is stronger now. Type what the spring scale reads, in N.");
    case Step::kDone: return say("The device is measured.");
    case Step::kFailed: return;
  }
}

void CalibrationProcedure::failWith(std::string sentence) {
  go(Step::kFailed);
  say(std::move(sentence));
}

void CalibrationProcedure::cancel() {
  if (step_ != Step::kDone && step_ != Step::kFailed) failWith("The measurement was canceled; nothing was kept.");
}

double CalibrationProcedure::movedFromStart() const { return length(difference(at_, start_)); }

Vector3 CalibrationProcedure::push(double share) const {
  share = std::clamp(share, -kLargestShare, kLargestShare);
  return {signs_[0] * share * drive_.x, signs_[1] * share * drive_.y, signs_[2] * share * drive_.z};
}

Vector3 CalibrationProcedure::tick(const DeviceState& raw, std::int64_t now_ns) {
  now_ns_ = now_ns;
  at_ = {raw.position_mm.x, raw.position_mm.y, raw.position_mm.z};
  const bool running = step_ != Step::kDone && step_ != Step::kFailed;
  if (running && raw.fault != DeviceFault::kNone && raw.fault != DeviceFault::kNotCalibrated)
    failWith("It cannot be measured: " + std::string(describe(raw.fault)) +
             ". Check cable, power and its switches, then begin anew.");
  if (!std::isfinite(length(at_))) failWith("The device reports a position that is no number.");
  lookAtAges(raw);
  if (just_entered_) {
    just_entered_ = false;
    step_ns_ = now_ns;
    start_ = lowest_ = highest_ = at_;
    samples_ = 0;
    sample_ = raw.number;
  }
  if (raw.number != sample_) ++samples_;
  sample_ = raw.number;

  switch (step_) {
    case Step::kRest: return rest();
    case Step::kSign: return sign();
    case Step::kFrictionIn: return rising(1);
    case Step::kFrictionOut:
    case Step::kLift: return rising(-1);
    case Step::kScaleLow: return held(kLowShare);
    case Step::kScaleHigh: return held(kHighShare);
    default: return {};
  }
}

/// A push that does not arrive, or a position from before it, would be measured all the same.
void CalibrationProcedure::lookAtAges(const DeviceState& raw) {
  const bool measures = step_ != Step::kLetGo && step_ != Step::kRest && step_ != Step::kDone && step_ != Step::kFailed;
  if (!measures) return;
  const char* const advice = " for 0.2 s. Check its cable, close other programs that use it, then begin anew.";
  // A device that is silent when still says nothing by its silence.
  if (!silent_ && raw.number > 0 && secondsBetween(raw.time_ns, now_ns_) > kOldestS)
    failWith(std::string("The device has sent no position") + advice);
  else if (raw.written_ns != 0 && secondsBetween(raw.written_ns, now_ns_) > kOldestS)
    failWith(std::string("No force has reached the device") + advice);
}

Vector3 CalibrationProcedure::rest() {
  double noise = 0;
  for (std::size_t i = 0; i < at_.size(); ++i) {
    lowest_[i] = std::min(lowest_[i], at_[i]);
    highest_[i] = std::max(highest_[i], at_[i]);
    noise = std::max(noise, highest_[i] - lowest_[i]);
  }
  if (noise > kRestlessCounts) {
    go(Step::kLetGo);
    say("The handle moved. Let it come to rest, keep clear of it, then continue.");
    return {};
  }
  if (elapsedS() < kRestS) return {};
  threshold_ = std::max(kLeastThreshold, 3 * noise);
  silent_ = samples_ < kLeastRate * kRestS;
  axis_ = 0;
  while (!plan_.driven[axis_]) ++axis_;
  beginPushAlong(axis_, kSignShare);
  return {};
}

void CalibrationProcedure::beginPushAlong(std::size_t axis, double share) {
  axis_ = axis;
  sign_share_ = share;
  sign_seen_ = false;
  go(Step::kSign);
}

Vector3 CalibrationProcedure::sign() {
  const double moved = at_[axis_] - start_[axis_];
  if (!sign_seen_ && std::abs(moved) > threshold_) {
    sign_seen_ = true;
    signs_[axis_] = moved > 0 ? 1 : -1;
  }
  if (elapsedS() < kSignS && !sign_seen_) {
    Vector3 force;
    component(force, axis_) = sign_share_;
    return force;
  }
  if (elapsedS() < kSignWatchS + kSettleS) return {};
  if (!sign_seen_) {
    if (sign_share_ < 3 * kSignShare - 1e-9) {
      beginPushAlong(axis_, sign_share_ + kSignShare);
    } else {
      failWith("The handle did not move along " + std::string(kAxisNames[axis_]) + " at " + percent(sign_share_) +
               " of full scale. Is the motor power on, and is the handle free?");
    }
    return {};
  }
  for (std::size_t next = axis_ + 1; next < plan_.driven.size(); ++next) {
    if (!plan_.driven[next]) continue;
    beginPushAlong(next, kSignShare);
    return {};
  }
  go(Step::kOuterEnd);
  return {};
}

Vector3 CalibrationProcedure::rising(double direction) {
  if (elapsedS() < kSettleS) {
    // What the step before set in motion has to come to rest first.
    start_ = at_;
    return {};
  }
  const double share = (elapsedS() - kSettleS) * kRiseShareS;
  const bool moved = movedFromStart() > threshold_;
  if (!moved && share < kLargestShare) return push(direction * share);
  const std::optional<double> at_motion = moved ? std::optional(share) : std::nullopt;
  if (step_ == Step::kFrictionIn) {
    friction_in_ = at_motion;
    go(Step::kFrictionOut);
  } else if (step_ == Step::kFrictionOut) {
    friction_out_ = at_motion;
    go(plan_.method == ScaleMethod::kSpringScale ? Step::kScaleReady : Step::kWeight);
  } else if (!moved) {
    failWith("The weight did not move at " + percent(kLargestShare) + " of full scale. Begin anew with a lighter one.");
  } else if (const double lift = share - friction_out_.value_or(0); lift < 0.01) {
    failWith("The weight is too light beside the device's own friction. Begin anew with a heavier one.");
  } else {
    full_scale_n_ = weight_n_ / lift;
    go(Step::kDone);
  }
  return {};
}

Vector3 CalibrationProcedure::held(double share) {
  if (movedFromStart() * mm_per_count_ > kSlipMm) {
    go(Step::kScaleReady);
    say("The handle slipped away. Hold it back with the spring scale, then continue.");
    return {};
  }
  if (elapsedS() > kLongestHoldS) {
    go(Step::kScaleReady);
    say("The motors rest. Hold the handle back with the spring scale, then continue.");
    return {};
  }
  const double from = step_ == Step::kScaleHigh ? kLowShare : 0;
  return push(-(from + (share - from) * std::min(elapsedS() / kRampS, 1.0)));
}

void CalibrationProcedure::proceed() {
  if (just_entered_) return;  // nothing was seen in this step yet
  switch (step_) {
    case Step::kLetGo: return go(Step::kRest);
    case Step::kOuterEnd: outer_ = at_; return go(Step::kInnerEnd);
    case Step::kInnerEnd: return takeInnerEnd();
    case Step::kLetGoAgain: return go(Step::kFrictionIn);
    case Step::kScaleReady: return go(Step::kScaleLow);
    default: return;
  }
}

void CalibrationProcedure::takeInnerEnd() {
  travel_ = difference(at_, outer_);
  const double counts = length(travel_);
  if (counts < 10 * threshold_)
    return say("That is too short to measure. Move the handle further inwards, then continue.");
  inwards_ = {travel_[0] / counts, travel_[1] / counts, travel_[2] / counts};
  driven_share_ = drivenShare(inwards_, plan_.driven);
  if (driven_share_ < kLeastDrivenShare)
    return failWith("This way is " + degrees(driven_share_) + " off the motors, which push along " +
                    motorWords(plan_.driven) + "; " + degrees(kLeastDrivenShare) +
                    " are the most. Begin anew with a way along them.");
  drive_ = (1 / driven_share_) * drivenPart(inwards_, plan_.driven);
  go(Step::kRuler);
}

/// The push acts along the motors, so that is what the scale has to hold.
std::string CalibrationProcedure::scaleDirection() const {
  if (driven_share_ > kAligned) return "the way the tube goes";
  const bool one = std::count(plan_.driven.begin(), plan_.driven.end(), true) == 1;
  return (one ? "straight along " : "in the plane of ") + motorWords(plan_.driven) + ", " + degrees(driven_share_) +
         " beside the way of the tube";
}

base::Result<void> CalibrationProcedure::enter(double value) {
  if (wanted() != CalibrationInput::kNumber || just_entered_)
    return base::fail(base::ErrorCode::kValue, "measurement", "a number", "no number in this step");
  const double low = step_ == Step::kRuler ? 5 : 0.01;
  const double high = step_ == Step::kRuler ? 1000 : 200;
  if (!(value >= low && value <= high))
    return base::fail(base::ErrorCode::kValue, "measurement", base::formatNumber(value),
                      "a number from " + base::formatNumber(low) + " to " + base::formatNumber(high));
  if (step_ == Step::kRuler) {
    mm_per_count_ = value / length(travel_);
    go(Step::kLetGoAgain);
  } else if (step_ == Step::kWeight) {
    weight_n_ = value;
    go(Step::kLift);
  } else if (elapsedS() < kRampS) {
    return base::fail(base::ErrorCode::kValue, "measurement", "a reading while the push still rises",
                      "one after it has settled");
  } else if (step_ == Step::kScaleLow) {
    low_n_ = value;
    go(Step::kScaleHigh);
  } else {
    return finishWithReadings(value);
  }
  return {};
}

base::Result<void> CalibrationProcedure::finishWithReadings(double high_n) {
  const double full = (high_n - low_n_) / (kHighShare - kLowShare);
  if (!(full > 0) || low_n_ > 2 * kLowShare * full)
    return base::fail(base::ErrorCode::kValue, "measurement",
                      base::formatNumber(low_n_) + " N and then " + base::formatNumber(high_n) + " N",
                      "about twice as much at the second push");
  full_scale_n_ = full;
  go(Step::kDone);
  return {};
}

base::Result<DeviceCalibration> CalibrationProcedure::result(const std::string& measured_at) const {
  if (step_ != Step::kDone)
    return base::fail(base::ErrorCode::kData, "measurement", "a step that is not the last", "a finished measurement");
  DeviceCalibration out;
  out.device = plan_.device;
  out.serial = plan_.serial;
  out.full_scale_n = full_scale_n_;
  out.force_sign = {signs_[0], signs_[1], signs_[2]};
  out.mm_per_count = mm_per_count_;
  out.inwards = inwards_;
  out.origin_mm = mm_per_count_ * Vector3{outer_[0], outer_[1], outer_[2]};
  // A push of the motors that moves the handle along the axis is the friction that the hand feels there.
  const double full_along_n = driven_share_ * full_scale_n_;
  if (friction_in_) out.friction_in_n = *friction_in_ * full_along_n;
  if (friction_out_) out.friction_out_n = *friction_out_ * full_along_n;
  out.silent_when_still = silent_;
  out.measured_at = measured_at;
  out.procedure = plan_.method == ScaleMethod::kSpringScale ? "guided 2, spring scale" : "guided 2, known weight";
  if (auto checked = checkCalibration(out); !checked) return tl::unexpected(checked.error());
  return out;
}

}  // namespace tactus::haptics
