#include <algorithm>
#include <cmath>
#include <utility>

#include "app/devices/guided_runs.h"
#include "core/base/text.h"

namespace tactus::devices {
namespace {

using base::formatFixed;
using base::formatNumber;
using haptics::DeviceFault;
using haptics::TripCause;

std::string millimeters(double value_mm) { return formatFixed(value_mm, 2) + " mm"; }

std::string_view faultAdvice(DeviceFault fault) {
  switch (fault) {
    case DeviceFault::kSwitchedOff: return "switch the forces on at the device, and close other programs that use it";
    case DeviceFault::kWarmMotors: return "let it cool down for some minutes";
    default: return "unplug it, plug it in again, and repeat the test";
  }
}

DeviceFault faultOf(const haptics::Trip& trip) { return static_cast<DeviceFault>(static_cast<int>(trip.value)); }

}  // namespace

std::string_view describe(Check check) noexcept {
  constexpr std::string_view kTexts[kChecks] = {"samples arrive", "calibrated",  "position follows the hand", "button",
                                                "no force",       "small force", "direction of the force"};
  return kTexts[static_cast<int>(check)];
}

std::string_view SelfTest::name(Phase phase) noexcept {
  constexpr std::string_view kNames[] = {"samples", "motion", "button", "force_off", "pulse", "ask", "done"};
  return kNames[static_cast<int>(phase)];
}

std::string SelfTest::instruction() const {
  switch (phase_) {
    case Phase::kMotion: return "Move the handle about 5 cm away from you, then back.";
    case Phase::kButton: return "Press a button of the handle and let it go.";
    case Phase::kForceOff: return "Hold the handle loosely and still. Press the button and keep it pressed.";
    case Phase::kPulse:
      return "Keep the button pressed. You will feel " + std::to_string(settings_.pulses) + " soft pulls of " +
             formatNumber(settings_.pulse_n) + " N.";
    case Phase::kAsk: return "Did it pull toward you, push away from you, or did you feel nothing?";
    default: return {};
  }
}

void SelfTest::tripped(const haptics::Trip& trip) {
  if (finished()) return;
  const bool fault = trip.cause == TripCause::kDeviceFault;
  if (fault && faultOf(trip) == DeviceFault::kNotCalibrated)
    return fail(Check::kCalibration, haptics::sentence(trip), settings_.calibration_advice);
  if (fault) return fail(current(), haptics::sentence(trip), std::string(faultAdvice(faultOf(trip))));
  fail(current(), haptics::sentence(trip), "check the cable and the power supply of the device, then repeat the test");
}

void SelfTest::lostPatience() {
  const std::string waited = " within " + formatNumber(settings_.patience_s) + " s";
  switch (phase_) {
    case Phase::kMotion:
      return fail(Check::kMotion,
                  "moved by " + millimeters(seen_.inwards_mm) + " inwards and " + millimeters(seen_.outwards_mm) +
                      " outwards" + waited,
                  "move it at least " + formatNumber(settings_.move_mm) + " mm away from you and back");
    case Phase::kButton:
      return fail(Check::kButton, (seen_.button_up ? "no press and release" : "a button that stays down") + waited,
                  "press a button of the device; without one it cannot be used");
    case Phase::kForceOff:
      return fail(Check::kForceOff, "the button was not held for 1.3 s" + waited,
                  "press the button and keep it pressed");
    default: return fail(current(), "no end" + waited, "press the button and keep it pressed");
  }
}

namespace {

using base::formatFixed;
using base::formatNumber;
using haptics::ForceSource;
using haptics::Sample;
using haptics::StimulusPhase;
using haptics::TripCause;

constexpr std::uint32_t kAnyButton = 0xFFFFFFFF;
constexpr int kSampleTicks = 500;
constexpr std::int64_t kOldestNs = 20'000'000;  ///< older samples give no force (limits: stale_zero_s)
constexpr int kSettleTicks = 300;               ///< after a press the hand comes to rest
constexpr int kMeanTicks = 100;
constexpr int kHoldTicks = 1000;  ///< held without force; the fade-in of 1 s is over then, too
constexpr int kRestTicks = 300;   ///< between two pulses
constexpr double kPulseHoldS = 0.5;
constexpr double kRampS = 0.15;
constexpr int kMostTries = 3;
constexpr double kEnoughShare = 0.9;  ///< of the pulse has to pass the limits

std::string mm(double value_mm) { return formatFixed(value_mm, 2) + " mm"; }

}  // namespace

SelfTest::SelfTest(SelfTestSettings settings) : settings_(std::move(settings)) { order(ForceSource::kFree); }

std::optional<haptics::ServoOrders> SelfTest::takeOrders() { return std::exchange(next_, std::nullopt); }

void SelfTest::order(ForceSource source) {
  haptics::ServoOrders orders;
  orders.source = source;
  orders.armed = source != ForceSource::kOff;
  orders.axis = settings_.axis;
  orders.limits = settings_.limits;
  orders.enable.button_mask = kAnyButton;
  orders.stimulus.number = pulse_;
  orders.stimulus.force_n = settings_.pulse_n;
  orders.stimulus.ramp_s = kRampS;
  orders.stimulus.hold_limit_s = kPulseHoldS;
  next_ = std::move(orders);
}

void SelfTest::enter(Phase phase) {
  phase_ = phase;
  seen_ = {};
  held_ = {};
  tries_ = 0;
  if (phase == Phase::kDone) order(ForceSource::kOff);
}

void SelfTest::pass(Check check, std::string found) { results_.push_back({check, true, std::move(found), {}}); }

void SelfTest::fail(Check check, std::string found, std::string advice) {
  results_.push_back({check, false, std::move(found), std::move(advice)});
  enter(Phase::kDone);
}

bool SelfTest::passed() const noexcept {
  return results_.size() == kChecks &&
         std::all_of(results_.begin(), results_.end(), [](const auto& r) { return r.passed; });
}

Check SelfTest::current() const noexcept {
  switch (phase_) {
    case Phase::kSamples: return Check::kSamples;
    case Phase::kMotion: return Check::kMotion;
    case Phase::kButton: return Check::kButton;
    case Phase::kForceOff: return Check::kForceOff;
    case Phase::kPulse: return Check::kPulse;
    default: return Check::kDirection;
  }
}

void SelfTest::feed(const Sample& sample) {
  if (finished() || sample.orders < orders_ || sample.trip != TripCause::kNone) return;
  if (seen_.ticks++ == 0) {
    seen_.since_ns = sample.time_ns;
    seen_.start_mm = sample.position_mm;
  }
  if (phase_ != Phase::kAsk && static_cast<double>(sample.time_ns - seen_.since_ns) * 1e-9 > settings_.patience_s)
    return lostPatience();
  switch (phase_) {
    case Phase::kSamples: return checkSamples(sample);
    case Phase::kMotion: return checkMotion(sample);
    case Phase::kButton: return checkButton(sample);
    case Phase::kForceOff: return checkForceOff(sample);
    case Phase::kPulse: return checkPulse(sample);
    default: return;
  }
}

void SelfTest::checkSamples(const Sample& sample) {
  // The first samples are those of a device that is just starting.
  if (seen_.ticks > kMeanTicks) seen_.oldest_ns = std::max(seen_.oldest_ns, sample.read_age_ns);
  if (seen_.ticks < kSampleTicks) return;
  const std::string oldest = "the oldest " + formatFixed(static_cast<double>(seen_.oldest_ns) * 1e-6, 1) + " ms";
  const std::string position = "position " + mm(sample.position_mm);
  if (seen_.oldest_ns > kOldestNs)
    return fail(Check::kSamples, oldest, "close other programs that use the device; plug it in without a hub");
  if (!(std::abs(sample.position_mm) <= settings_.farthest_mm))
    return fail(Check::kSamples, position, "calibrate the device: no hand reaches so far");
  pass(Check::kSamples, oldest + ", " + position);
  pass(Check::kCalibration, "the device reports no fault");
  enter(Phase::kMotion);
}

void SelfTest::checkMotion(const Sample& sample) {
  const double moved_mm = sample.position_mm - seen_.start_mm;
  seen_.inwards_mm = std::max(seen_.inwards_mm, moved_mm);
  seen_.outwards_mm = std::max(seen_.outwards_mm, -moved_mm);
  if (seen_.outwards_mm >= settings_.move_mm && seen_.inwards_mm < settings_.move_mm / 2) {
    const std::string turn = settings_.axis_advice.empty() ? "" : "; if you did, " + settings_.axis_advice;
    return fail(Check::kMotion, mm(seen_.outwards_mm) + " outwards first", "move it away from you first" + turn);
  }
  if (seen_.inwards_mm < settings_.move_mm || moved_mm > settings_.move_mm / 2) return;
  pass(Check::kMotion, mm(seen_.inwards_mm) + " inwards and back");
  enter(Phase::kButton);
}

void SelfTest::checkButton(const Sample& sample) {
  if (sample.buttons == 0) seen_.button_up = true;
  if (seen_.button_up && sample.buttons != 0) seen_.button = sample.buttons;
  if (seen_.button == 0 || sample.buttons != 0) return;
  int number = 1;
  while (((seen_.button >> (number - 1)) & 1u) == 0) ++number;
  pass(Check::kButton, "button " + std::to_string(number) + " went down and up");
  enter(Phase::kForceOff);
}

void SelfTest::checkForceOff(const Sample& sample) {
  if (sample.force_n != 0)
    return fail(Check::kForceOff, formatNumber(sample.force_n) + " N without a source", "do not use the device");
  if (!sample.enabled) {
    held_ = {};
    return;
  }
  ++held_.ticks;
  const int measured = held_.ticks - kSettleTicks;
  if (measured > 0 && measured <= kMeanTicks) held_.before.add(sample.position_mm);
  if (measured > kHoldTicks - kMeanTicks) held_.after.add(sample.position_mm);
  if (measured < kHoldTicks) return;
  drift_mm_ = std::abs(held_.after.mm() - held_.before.mm());
  held_ = {};
  if (drift_mm_ <= settings_.most_drift_mm) {
    pass(Check::kForceOff, "held for 1 s, moved by " + mm(drift_mm_));
    return enter(Phase::kPulse);
  }
  if (++tries_ < kMostTries) return;
  fail(Check::kForceOff, "held without force it moved by " + mm(drift_mm_),
       "hold it still; if the device pulls by itself, do not use it");
}

void SelfTest::checkPulse(const Sample& sample) {
  if (held_.rest > 0) {
    --held_.rest;
    return;
  }
  if (!held_.pulsing) {
    if (!sample.enabled) {
      held_ = {};
      return;
    }
    held_.before.add(sample.position_mm);
    if (held_.before.count < kMeanTicks) return;
    held_.pulsing = true;
    ++pulse_;
    return order(ForceSource::kStimulus);
  }
  if (sample.stimulus == StimulusPhase::kFull) {
    largest_force_n_ = std::max(largest_force_n_, std::abs(sample.force_n));
    if (sample.since_full_s > kPulseHoldS - 1e-3 * kMeanTicks) held_.after.add(sample.position_mm);
  }
  const bool over =
      sample.stimulus == StimulusPhase::kEnded || (sample.stimulus == StimulusPhase::kWaiting && !sample.enabled);
  if (over) pulseEnded();
}

void SelfTest::pulseEnded() {
  if (held_.after.count >= kMeanTicks / 2) {
    shifts_mm_.push_back(held_.after.mm() - held_.before.mm());
  } else if (++tries_ >= kMostTries) {
    return fail(Check::kPulse, "the button was let go in " + std::to_string(tries_) + " pulls",
                "repeat the test and keep the button pressed");
  }
  held_ = {};
  held_.rest = kRestTicks;
  if (static_cast<int>(shifts_mm_.size()) < settings_.pulses) return;

  const std::string passed = formatFixed(largest_force_n_, 3) + " N of " + formatNumber(settings_.pulse_n) + " N";
  if (largest_force_n_ < kEnoughShare * settings_.pulse_n)
    return fail(Check::kPulse, "the limits let through only " + passed, "check the force cap and the continuous force");
  pass(Check::kPulse, passed + " reached the device");
  order(ForceSource::kFree);
  enter(Phase::kAsk);
}

double SelfTest::shiftMm() const {
  const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto largest = std::max_element(shifts_mm_.begin(), shifts_mm_.end(), smaller);
  return largest == shifts_mm_.end() ? 0 : *largest;
}

/// A held hand wanders by about as much as it is pulled, so only a clear motion speaks against what was felt.
bool SelfTest::clearlyInwards() const {
  double sum_mm = 0;
  double least_mm = 0;
  for (const double shift_mm : shifts_mm_) {
    sum_mm += shift_mm;
    least_mm = std::min(least_mm, shift_mm);
  }
  const double clear_mm = 2 * settings_.smallest_shift_mm;
  return sum_mm > clear_mm * static_cast<double>(shifts_mm_.size()) && least_mm > -settings_.smallest_shift_mm;
}

void SelfTest::cancel() {
  if (!finished()) enter(Phase::kDone);
}

void SelfTest::answer(Felt felt) {
  if (phase_ != Phase::kAsk) return;
  const double shift_mm = shiftMm();
  const std::string moved = "the hand moved by " + mm(std::abs(shift_mm)) + (shift_mm > 0 ? " inwards" : " outwards");
  if (felt == Felt::kNothing)
    return fail(Check::kDirection, "nothing was felt, " + moved,
                "check the device's power supply and its force switch, then calibrate its force");
  if (felt == Felt::kAway)
    return fail(Check::kDirection, "a push away from the person, " + moved,
                "do not use it: turn the sign of its force around by calibrating it");
  if (clearlyInwards())
    return fail(Check::kDirection, "a pull toward the person was felt, but " + moved,
                "repeat the test; if this comes again, calibrate the sign of the force");
  pass(Check::kDirection, "a pull toward the person, " + moved);
  enter(Phase::kDone);
}

}  // namespace tactus::devices
