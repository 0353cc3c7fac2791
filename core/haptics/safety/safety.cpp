#include "core/haptics/safety/safety.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/haptics/device/device.h"
#include "core/render/low_pass.h"
#include "core/render/renderer_state.h"

namespace tactus::haptics {
namespace {

std::string_view describe(render::Fault fault) noexcept {
  switch (fault) {
    case render::Fault::kPosition: return "a position was not a number, or beyond 1 km";
    case render::Fault::kForce: return "the model's force was not a number";
    case render::Fault::kTime: return "a tick was shorter than a microsecond or longer than a second";
    default: return "for a reason that it does not tell";
  }
}

}  // namespace

std::string_view describe(TripCause cause) noexcept {
  switch (cause) {
    case TripCause::kNone: return "no trip";
    case TripCause::kForceNotFinite: return "the force was not a finite number";
    case TripCause::kPositionNotFinite: return "the position was not a finite number";
    case TripCause::kTooFastInwards: return "the hand moved inwards too fast";
    case TripCause::kTooFastOutwards: return "the hand moved outwards too fast";
    case TripCause::kDeviceSilent: return "the device sent no sample for too long";
    case TripCause::kWriteStuck: return "no force reached the device for too long";
    case TripCause::kServoLate: return "the servo missed ticks for too long";
    case TripCause::kDeviceLost: return "the device is gone";
    case TripCause::kDeviceFault: return "the device reports a fault";
    case TripCause::kRenderer: return "the renderer let go";
    case TripCause::kStopped: return "Stop was pressed";
  }
  return "unknown trip";
}

std::string_view unitOf(TripCause cause) noexcept {
  switch (cause) {
    case TripCause::kTooFastInwards:
    case TripCause::kTooFastOutwards: return "mm/s";
    case TripCause::kDeviceSilent:
    case TripCause::kWriteStuck:
    case TripCause::kServoLate: return "s";
    default: return "";
  }
}

std::string sentence(const Trip& trip) {
  std::string text(describe(trip.cause));
  if (trip.cause == TripCause::kDeviceFault)
    return std::string(describe(static_cast<DeviceFault>(static_cast<int>(trip.value))));
  if (trip.cause == TripCause::kRenderer)
    return text + ": " + std::string(describe(static_cast<render::Fault>(static_cast<int>(trip.value))));
  const std::string_view unit = unitOf(trip.cause);
  if (unit.empty()) return text;
  const int decimals = unit == "s" ? 3 : 0;
  text += ": " + base::formatFixed(trip.value, decimals) + ' ' + std::string(unit);
  return text + ", allowed " + base::formatFixed(trip.limit, decimals) + ' ' + std::string(unit);
}

void EnableSwitch::rest() noexcept {
  on_ = false;
  ready_ = false;
  spent_ = false;
}

void EnableSwitch::update(const SwitchInput& input, const EnableSettings& settings) noexcept {
  const bool another = settings.kind != kind_ || settings.button_mask != button_mask_;
  kind_ = settings.kind;
  button_mask_ = settings.button_mask;
  if (another || input.armed != armed_) {
    if (armed_ && !input.armed) let_go_ = false;
    rest();
  }
  armed_ = input.armed;
  if (!input.down) {
    changed_ns_ = input.now_ns;  // it may have been let go meanwhile
    return;
  }

  const bool down = *input.down;
  if (down != down_ || another) changed_ns_ = input.now_ns;
  if (!down && !armed_) let_go_ = true;
  if (!down) ready_ = true;
  if (!armed_) {
    on_ = false;
  } else if (ready_ && kind_ == EnableKind::kLatch) {
    latched(input, settings, down);
  } else if (ready_) {
    held(input, settings, down);
  }
  down_ = down;
}

void EnableSwitch::held(const SwitchInput& input, const EnableSettings& settings, bool down) noexcept {
  if (!down) {
    on_ = false;
    spent_ = false;
  } else if (!spent_ && secondsBetween(changed_ns_, input.now_ns) >= settings.press_debounce_s) {
    spent_ = true;
    on_ = !settings.start_zone_mm || std::abs(input.position_mm) <= *settings.start_zone_mm;
  }
}

void EnableSwitch::latched(const SwitchInput& input, const EnableSettings& settings, bool down) noexcept {
  const double since_s = secondsBetween(changed_ns_, input.now_ns);
  const bool outside = !(input.position_mm >= settings.release_zone_mm);
  if (outside) on_ = false;
  if (!down) {
    // The press that switched on has ended for good once its contact no longer bounces.
    if (since_s >= settings.press_debounce_s) spent_ = false;
  } else if (on_ && !spent_) {
    on_ = false;  // switching off needs no debounce
    spent_ = true;
  } else if (!spent_ && since_s >= settings.press_debounce_s) {
    spent_ = true;
    on_ = !outside && (!settings.start_zone_mm || std::abs(input.position_mm) <= *settings.start_zone_mm);
  }
}

namespace {

constexpr std::int64_t kSpanNs = 15'000'000;
constexpr std::int64_t kShortestSpanNs = 8'000'000;
constexpr std::int64_t kClosestNs = 500'000;

/// Of the first `count` values, which it sorts.
template <class Value, std::size_t kSize>
Value median(std::array<Value, kSize>& values, int count) noexcept {
  const auto middle = values.begin() + count / 2;
  std::nth_element(values.begin(), middle, values.begin() + count);
  return *middle;
}

}  // namespace

void VelocityGuard::add(std::uint64_t number, std::int64_t time_ns, double position_mm) noexcept {
  if (number == number_) {
    // Renewed and nothing else: a device that is silent when still. After a whole window of it the hand rests.
    if (count_ > 0 && time_ns - back(0).time_ns >= kSpanNs) speed_mm_s_ = 0;
    return;
  }
  number_ = number;
  if (count_ > 0 && time_ns < back(0).time_ns) count_ = 0;  // another clock or another device
  if (count_ > 0 && time_ns - back(0).time_ns < kClosestNs) return;
  newest_ = count_ == 0 ? kRoom : newest_ + 1;
  if (newest_ >= 2 * kRoom) newest_ -= kRoom;
  points_[static_cast<std::size_t>(newest_) % kRoom] = {time_ns, position_mm};
  count_ = std::min(count_ + 1, kRoom);
  speed_mm_s_ = fitted();
}

Trip VelocityGuard::check(const LimitSettings& limits) const noexcept {
  if (!limits.guard_velocity) return {};
  if (speed_mm_s_ > limits.inward_guard_mm_s)
    return {TripCause::kTooFastInwards, speed_mm_s_, limits.inward_guard_mm_s, 0};
  if (-speed_mm_s_ > limits.outward_guard_mm_s)
    return {TripCause::kTooFastOutwards, -speed_mm_s_, limits.outward_guard_mm_s, 0};
  return {};
}

double VelocityGuard::fitted() const noexcept {
  int used = 1;
  while (used < count_ && back(0).time_ns - back(used - 1).time_ns < kSpanNs) ++used;
  if (back(0).time_ns - back(used - 1).time_ns < kShortestSpanNs) return 0;

  std::array<std::int64_t, kRoom> late_ns{};
  std::array<std::int64_t, kRoom> early_ns{};
  std::array<double, kRoom> late_mm{};
  std::array<double, kRoom> early_mm{};
  // Odd, so that the medians of times and positions belong to the same sample.
  const int third = std::max(0, used / 3 - 1) | 1;
  for (int i = 0; i < third; ++i) {
    const auto at = static_cast<std::size_t>(i);
    late_ns[at] = back(i).time_ns;
    late_mm[at] = back(i).position_mm;
    early_ns[at] = back(used - 1 - i).time_ns;
    early_mm[at] = back(used - 1 - i).position_mm;
  }
  const double way_mm = median(late_mm, third) - median(early_mm, third);
  return way_mm / (1e-9 * static_cast<double>(median(late_ns, third) - median(early_ns, third)));
}

namespace {

constexpr double kStaleConstantS = 0.010;

}  // namespace

Trip overdue(const Ages& ages, const LimitSettings& limits) noexcept {
  // A servo that did not run saw no sample and wrote no force: the other two follow from it.
  if (ages.gap_s > limits.servo_trip_s) return {TripCause::kServoLate, ages.gap_s, limits.servo_trip_s, 0};
  if (ages.sample_s > limits.stale_trip_s) return {TripCause::kDeviceSilent, ages.sample_s, limits.stale_trip_s, 0};
  if (ages.write_s > limits.write_trip_s) return {TripCause::kWriteStuck, ages.write_s, limits.write_trip_s, 0};
  return {};
}

double staleShare(double age_s, const LimitSettings& limits) noexcept {
  if (age_s <= limits.stale_decay_s) return 1;
  if (age_s >= limits.stale_zero_s) return 0;
  const double last = render::decay(limits.stale_zero_s - limits.stale_decay_s, kStaleConstantS);
  return (render::decay(age_s - limits.stale_decay_s, kStaleConstantS) - last) / (1 - last);
}

namespace {

/// After a stall the force moves on as after a tick of this length, so that it does not jump to where it should be.
constexpr double kLongestStepS = 0.002;
/// A servo that is later than this has stood still.
constexpr double kStandstillS = 0.005;
/// No device is as large; further out is as little of a position as a NaN.
constexpr double kFarthestMm = 1e6;
/// Smaller forces become 0, so that nothing works on denormal numbers.
constexpr double kSmallestN = 1e-12;

bool isPosition(double position_mm) noexcept { return std::abs(position_mm) <= kFarthestMm; }

/// Whether the force of this trip goes in one tick; docs/servo.md has the reasons.
bool cuts(const Trip& trip) noexcept {
  switch (trip.cause) {
    case TripCause::kTooFastInwards:
    case TripCause::kTooFastOutwards:
    case TripCause::kRenderer: return false;
    case TripCause::kDeviceFault:
      return trip.value != static_cast<double>(DeviceFault::kWarmMotors) &&
             trip.value != static_cast<double>(DeviceFault::kForceLimited);
    default: return true;
  }
}

/// From `from_n` toward `to_n` in `step_s`: away from zero and toward it each at its own rate, also across zero.
double slewed(double from_n, double to_n, double step_s, const LimitSettings& limits) noexcept {
  const double toward_n = limits.release_slew_n_s * step_s;
  const double away_n = limits.slew_n_s * step_s;
  if (from_n < 0) return -slewed(-from_n, -to_n, step_s, limits);
  if (to_n >= from_n) return std::min(to_n, from_n + away_n);
  if (to_n >= 0) return std::max(to_n, from_n - toward_n);
  if (from_n > toward_n) return from_n - toward_n;
  const double left = toward_n > 0 ? 1 - from_n / toward_n : 0;  // share of the tick on the other side of zero
  return std::max(to_n, -left * away_n);
}

}  // namespace

void Safety::begin(const SafetyInput& input, const EnableSettings& enable, const LimitSettings& limits) noexcept {
  passTime(input, limits);
  if (input.armed != armed_) arm(input.armed);
  if (input.let_go) switch_.spend();
  switch_.update({now_ns_, armed_, contact(input, enable), input.position_mm}, enable);

  const Trip speeding = velocity_.check(limits);
  if (const Trip found = wrong(input, limits)) trip(found);
  if (engaged_ && switch_.on() && speeding) trip(speeding);
  engaged_ = switch_.on() && (engaged_ || !speeding);

  gui_silent_ = input.heartbeat_ns != 0 && secondsBetween(input.heartbeat_ns, now_ns_) > limits.gui_silent_s;
  if (gui_silent_) faded_in_s_ = 0;

  const bool enabled = armed_ && !trip_ && engaged_ && fresh_ && !gui_silent_;
  if (!enabled) disable();
  enabled_ = enabled;
  if (!enabled_ || !input.follows_motion || input.another_axis) passivity_.reset(now_ns_, input.position_mm);
}

void Safety::passTime(const SafetyInput& input, const LimitSettings& limits) noexcept {
  before_ns_ = running_ ? now_ns_ : input.now_ns;
  now_ns_ = std::max(before_ns_, input.now_ns);
  running_ = true;
  const double elapsed_s = secondsBetween(before_ns_, now_ns_);
  step_s_ = std::min(elapsed_s, kLongestStepS);
  heat(elapsed_s, limits);
  const bool let_go = deviceLetGo(input, limits);
  if (let_go) beginAnew();
  in_gap_ = let_go;

  const bool sampled = input.device != nullptr && input.device->number > 0;
  sample_age_s_ = sampled ? std::optional(secondsBetween(input.device->time_ns, now_ns_)) : std::nullopt;
  fresh_ = sample_age_s_ && *sample_age_s_ < limits.stale_zero_s;
  if (input.another_axis) velocity_.forget();
  if (!sampled || !isPosition(input.position_mm)) return;
  velocity_.add(input.device->number, input.device->time_ns, input.position_mm);
  if (let_go) {
    passivity_.reset(now_ns_, input.position_mm);
  } else {
    passivity_.observe(now_ns_, input.position_mm, force_n_, limits.loop_delay_s);
  }
}

/// What the motors gave since the last tick. A force that is not renewed counts in full, for as long as it could last.
void Safety::heat(double elapsed_s, const LimitSettings& limits) noexcept {
  const bool to_the_end = !told_nothing_ && elapsed_s <= ThermalBudget::kLongestHeldS;
  if (!told_nothing_ && !to_the_end) {
    const auto held_ns = static_cast<std::int64_t>(1e9 * ThermalBudget::kLongestHeldS);
    thermal_.advance(before_ns_ + held_ns, force_n_, limits.continuous_force_n, limits.thermal_window_s);
  }
  thermal_.advance(now_ns_, to_the_end ? force_n_ : 0, limits.continuous_force_n, limits.thermal_window_s);
}

ThermalBudget Safety::thermal() const noexcept {
  ThermalBudget after = thermal_;
  const double held_s = told_nothing_ ? 0 : std::min(hold_s_, ThermalBudget::kLongestHeldS);
  after.spend(now_ns_ + static_cast<std::int64_t>(1e9 * held_s), force_n_);
  return after;
}

/// Whether the device has had no command for longer than it holds one.
bool Safety::deviceLetGo(const SafetyInput& input, const LimitSettings& limits) noexcept {
  const bool told_nothing = told_nothing_;
  told_nothing_ = false;
  const double gap_s = secondsBetween(before_ns_, now_ns_);
  // A servo that is late at every tick gets no respite from the write watchdog.
  const bool late = gap_s > kStandstillS;
  if (late && !late_) resumed_ns_ = now_ns_;
  late_ = late;
  on_the_way_ = secondsBetween(resumed_ns_, now_ns_) <= limits.loop_delay_s + kLongestStepS;
  if (told_nothing || gap_s > hold_s_) return true;
  const std::int64_t written_ns = input.device != nullptr ? input.device->written_ns : 0;
  if (written_ns == 0 || on_the_way_) return false;
  // Once nothing arrives any more, what is asked for now arrives a delay later at the earliest.
  const double written_age_s = secondsBetween(written_ns, now_ns_);
  const double delay_s = written_age_s > kStandstillS ? limits.loop_delay_s : 0;
  return written_age_s + delay_s > hold_s_;
}

void Safety::beginAnew() noexcept {
  if (!enabled_ && force_n_ == 0) return;
  restarts_ += in_gap_ ? 0 : 1;
  force_n_ = 0;
  faded_in_s_ = 0;
  fading_from_gap_ = true;
}

void Safety::arm(bool armed) noexcept {
  armed_ = armed;
  if (!armed) return;
  armed_ns_ = now_ns_;
  before_ns_ = now_ns_;  // what was late before does not count
  faded_in_s_ = 0;
  fading_from_gap_ = false;
  if (!switch_.letGo()) return;
  trip_ = {};
}

std::optional<bool> Safety::contact(const SafetyInput& input, const EnableSettings& enable) const noexcept {
  if (enable.kind == EnableKind::kPedal || enable.kind == EnableKind::kKey) return input.pedal;
  if (!fresh_) return {};
  const bool pressed = (input.device->buttons & enable.button_mask) != 0;
  return pressed || (enable.kind == EnableKind::kLatch && input.pedal);
}

Trip Safety::wrong(const SafetyInput& input, const LimitSettings& limits) const noexcept {
  if (input.stop) return {TripCause::kStopped, 0, 0, 0};
  const DeviceFault fault = input.device != nullptr ? input.device->fault : DeviceFault::kNone;
  if (fault == DeviceFault::kLost) return {TripCause::kDeviceLost, 0, 0, 0};
  if (sample_age_s_ && !isPosition(input.position_mm)) return {TripCause::kPositionNotFinite, 0, 0, 0};
  if (fault != DeviceFault::kNone) return {TripCause::kDeviceFault, static_cast<double>(fault), 0, 0};

  const std::int64_t written_ns = input.device != nullptr ? input.device->written_ns : 0;
  Ages ages;
  ages.gap_s = secondsBetween(before_ns_, now_ns_);
  ages.sample_s = sample_age_s_.value_or(secondsBetween(armed_ns_, now_ns_));
  // A servo that stood still asked for nothing that could have been written.
  ages.write_s = on_the_way_ ? 0 : secondsBetween(std::max(armed_ns_, written_ns), now_ns_);
  return overdue(ages, limits);
}

void Safety::trip(const Trip& trip) noexcept {
  if (!trip) return;
  cut_ = cut_ || cuts(trip);
  if (!armed_ || trip_) return;
  trip_ = trip;
  trip_.time_ns = now_ns_;
  disable();
}

void Safety::disable() noexcept {
  if (!enabled_) return;
  enabled_ = false;
  released_n_ = std::abs(force_n_);
  released_ns_ = before_ns_;  // the hand may have let go right after the tick before
}

LimitedForce Safety::limit(double resistance_n, const LimitSettings& limits) noexcept {
  if (!std::isfinite(resistance_n)) trip({TripCause::kForceNotFinite, 0, 0, 0});
  LimitedForce out;
  double force_n = enabled_ ? asked(resistance_n, limits, out.limited) : released(limits);

  const double share = sample_age_s_ ? staleShare(*sample_age_s_, limits) : 0;
  if (share < 1) force_n = std::clamp(force_n, -share * fresh_n_, share * fresh_n_);
  if (cut_ || !std::isfinite(force_n) || std::abs(force_n) < kSmallestN) force_n = 0;
  cut_ = false;  // once at zero, a force comes back through a press alone
  if (share == 1) fresh_n_ = std::abs(force_n);

  if (share < 1) out.limited |= kLimitedByStaleDevice;
  if (gui_silent_) out.limited |= kLimitedByGui;
  if (!enabled_) out.limited |= kLimitedByRelease;
  if (trip_) out.limited |= kLimitedByTrip;
  force_n_ = out.force_n = force_n;
  return out;
}

double Safety::asked(double resistance_n, const LimitSettings& limits, std::uint32_t& limited) noexcept {
  const double damped_n = passivity_.control(resistance_n);
  if (damped_n != resistance_n) limited |= kLimitedByPassivity;

  const double cap_n = std::max(0.0, limits.force_cap_n);
  const double capped_n = std::clamp(damped_n, -cap_n, cap_n);
  if (capped_n != damped_n) limited |= kLimitedByCap;
  const double warm_n = std::clamp(capped_n, -thermal_.ceilingN(), thermal_.ceilingN());
  if (warm_n != capped_n) limited |= kLimitedByThermal;

  double wanted_n = warm_n;
  faded_in_s_ += step_s_;
  if (faded_in_s_ < limits.fade_in_s) {
    wanted_n *= faded_in_s_ / limits.fade_in_s;
    limited |= kLimitedByFadeIn;
    if (fading_from_gap_) limited |= kLimitedByGap;
  } else {
    fading_from_gap_ = false;
  }
  const double force_n = slewed(force_n_, wanted_n, step_s_, limits);
  if (force_n != wanted_n) limited |= kLimitedBySlew;
  return force_n;
}

double Safety::released(const LimitSettings& limits) const noexcept {
  const double left = 1 - secondsBetween(released_ns_, now_ns_) / limits.release_s;
  const double most_n = left > 0 ? released_n_ * left : 0;
  return std::clamp(force_n_, -most_n, most_n);
}

}  // namespace tactus::haptics
