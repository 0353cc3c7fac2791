// The safety layer: the last stage between a force and the device. It does not know the force model.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/haptics/device/device.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/safety/passivity_guard.h"
#include "core/haptics/safety/thermal_budget.h"

namespace tactus::haptics {

// A trip: the force goes to zero and stays there until the user arms again.

enum class TripCause : std::uint8_t {
  kNone,
  kForceNotFinite,     ///< a force source returned NaN or infinity; value: 0
  kPositionNotFinite,  ///< value: 0
  kTooFastInwards,     ///< value: mm/s
  kTooFastOutwards,    ///< value: mm/s
  kDeviceSilent,       ///< no sample; value: age in s
  kWriteStuck,         ///< no force reached the device; value: age in s
  kServoLate,          ///< ticks were missed; value: gap in s
  kDeviceLost,         ///< unplugged
  kDeviceFault,        ///< value: the DeviceFault
  kRenderer,           ///< the renderer released the force; value: the render::Fault
  kStopped,            ///< the user pressed Stop
};

struct Trip {
  TripCause cause = TripCause::kNone;
  double value = 0;          ///< the value found, in the unit of the cause
  double limit = 0;          ///< the allowed value, in the same unit; 0 if there is no limit
  std::int64_t time_ns = 0;  ///< of the tick

  explicit operator bool() const noexcept { return cause != TripCause::kNone; }
  bool operator==(const Trip&) const = default;
};

/// The cause in words for the user, e.g. `the hand moved outwards too fast`.
std::string_view describe(TripCause cause) noexcept;
/// Unit of value and limit, e.g. `mm/s`; empty if there is none.
std::string_view unitOf(TripCause cause) noexcept;
/// Cause, value and limit on one line, e.g. `the hand moved outwards too fast: 431 mm/s, allowed 400 mm/s`. A fault of
/// device or renderer appears in words, e.g. `the motors are too warm`. Each number has its unit. Real-time safe: no.
std::string sentence(const Trip& trip);

// Whether the hand holds the device: a held button, pedal or key, or a latch.

/// The input of one tick. `down` is empty if the contact is unknown (no sample). An unknown contact switches nothing
/// and restarts the debounce.
struct SwitchInput {
  std::int64_t now_ns = 0;
  bool armed = false;
  std::optional<bool> down;  ///< the contact
  double position_mm = 0;    ///< along the insertion axis
};

/// A press counts after the debounce time and inside the start zone. A release counts at once.
/// The contact must have been up once since the start, since arming, and since a change of the switch kind. So a stuck
/// button, or a hand that already holds the button, enables nothing. A press outside the start zone has no effect; the
/// user must press again.
/// Plain state. Thread: servo. Real-time safe: yes.
class EnableSwitch {
 public:
  void update(const SwitchInput& input, const EnableSettings& settings) noexcept;

  bool on() const noexcept { return on_; }
  /// Ends the current press: the user must release and press again. Call before `update` of the same tick.
  void spend() noexcept { rest(); }
  /// Whether the contact was up at least once since the last call with `armed` true: the hand has let go.
  bool letGo() const noexcept { return let_go_; }

 private:
  void rest() noexcept;
  void held(const SwitchInput& input, const EnableSettings& settings, bool down) noexcept;
  void latched(const SwitchInput& input, const EnableSettings& settings, bool down) noexcept;

  EnableKind kind_ = EnableKind::kButton;
  std::uint32_t button_mask_ = 1;
  bool armed_ = false;
  bool on_ = false;
  bool ready_ = false;           ///< the contact was up since arming, so a press may begin
  bool let_go_ = false;          ///< the contact was up since disarming
  bool down_ = false;            ///< the contact at the last tick
  bool spent_ = false;           ///< this press has had its effect or was rejected
  std::int64_t changed_ns_ = 0;  ///< time of the contact's last change
};

// Detects a hand that is too fast for the insertion of a tube: it has slipped, or a force drives it.

/// The speed is the slope of Tukey's resistant line (Exploratory Data Analysis, 1977) through the samples of the last
/// 15 ms: it joins the medians of the first and the last third. One count of 0.055 mm within 1 ms is 55 mm/s for a
/// plain difference and at most 5.5 mm/s here. A single wrong sample has no effect. A dropped tick or a stall counts as
/// elapsed time only.
/// Plain state. Thread: servo. Real-time safe: yes.
class VelocityGuard {
 public:
  /// Adds one sample of the device. `number`: its number. `time_ns`: its arrival time. A repeated sample is ignored. If
  /// its arrival time is renewed by 15 ms or more (a device that is silent at rest), the hand rests and the speed is 0.
  /// A stall renews nothing, so the next sample gives the mean speed since the last one.
  void add(std::uint64_t number, std::int64_t time_ns, double position_mm) noexcept;
  /// Speed, mm/s, positive inwards, about 5 ms late. 0 until the samples span 8 ms.
  double speedMmS() const noexcept { return speed_mm_s_; }
  /// The trip that this speed requires, or none. The caller sets `time_ns`.
  Trip check(const LimitSettings& limits) const noexcept;
  /// Forgets all samples, because positions have a new meaning.
  void forget() noexcept { *this = {}; }

 private:
  struct Point {
    std::int64_t time_ns = 0;
    double position_mm = 0;
  };
  static constexpr int kRoom = 32;  ///< 15 ms of samples that are at least 0.5 ms apart

  const Point& back(int steps) const noexcept { return points_[static_cast<std::size_t>(newest_ - steps) % kRoom]; }
  double fitted() const noexcept;

  std::array<Point, kRoom> points_{};
  std::uint64_t number_ = 0;
  int count_ = 0;
  int newest_ = 0;
  double speed_mm_s_ = 0;
};

// Detects silence of the device, the writes and the servo, and gives its consequence.

/// Ages at a tick, s.
struct Ages {
  double sample_s = 0;  ///< of the device's newest sample
  double write_s = 0;   ///< since a force last reached the device
  double gap_s = 0;     ///< since the last tick
};

/// The trip that these ages require, or none; a late servo comes first. The caller sets `time_ns`. Real-time safe: yes.
Trip overdue(const Ages& ages, const LimitSettings& limits) noexcept;

/// The remaining share of a force if the device's sample is `age_s` old: 1 up to `stale_decay_s`, 0 from `stale_zero_s`
/// on. Between them it decays exponentially with a time constant of 10 ms, shifted down so that it ends at 0 without a
/// step.
double staleShare(double age_s, const LimitSettings& limits) noexcept;

/// The input of one tick. The servo fills it before it asks any source.
struct SafetyInput {
  std::int64_t now_ns = 0;
  double position_mm = 0;               ///< along the insertion axis
  const DeviceState* device = nullptr;  ///< null is equal to a device without a sample; `written_ns` must persist
  bool armed = false;
  bool pedal = false;             ///< a pedal or a key of the program is down
  bool stop = false;              ///< Stop was pressed since the last tick
  std::int64_t heartbeat_ns = 0;  ///< time of the program's last heartbeat; 0: no heartbeat expected
  /// Whether the source's force depends on the motion of the hand (insertion). A force that does not (a stimulus)
  /// cannot drive a vibration, however much work it does, so the passivity guard ignores it.
  bool follows_motion = true;
  /// Positions have a new meaning since the last tick (another axis), so their difference is not a motion.
  bool another_axis = false;
  bool let_go = false;  ///< the press is used up: the force fades as after a release, until the user presses again
};

struct LimitedForce {
  double force_n = 0;         ///< resistance along the axis
  std::uint32_t limited = 0;  ///< LimitBit
};

/// Two calls per tick. `begin` decides whether the hand holds the device and whether a trip occurs. `limit` reduces the
/// source's force to the allowed value. Order: finite, passivity guard, cap and thermal budget, fade-in, slew, stale
/// device, release. See docs/servo.md, "Limits".
///
/// Trips: a trip is latched while armed. The force stays zero until the user disarms, lets go, and arms again, in this
/// order.
/// - If force or position cannot be trusted, the force is cut in one tick: force or position not finite, device lost or
///   silent, write stuck, servo late, device without calibration, switched off or failed, Stop.
/// - If position and device are sound, it fades within `release_s`, because a cut is felt as a kick: velocity guard,
///   renderer, warm motors, force limited by the device.
/// The first cause is kept. A later cause that requires a cut ends a fading force at once, armed or not.
///
/// Gaps: a device holds a command for its `hold_s`. After a longer gap (the servo stood still, or commands did not
/// arrive) the force in the hand is 0, whatever the last command was. The layer then starts from 0, with a new fade-in
/// and a new energy count (kLimitedByGap).
/// Plain state, copyable; the caller passes the time. Thread: servo. Real-time safe: yes.
class Safety {
 public:
  /// `hold_s`: as DeviceInfo::hold_s. `thermal`: the load of the motors so far.
  explicit Safety(double hold_s = DeviceInfo{}.hold_s, const ThermalBudget& thermal = {}) noexcept
      : hold_s_(hold_s), thermal_(thermal) {}

  void begin(const SafetyInput& input, const EnableSettings& enable, const LimitSettings& limits) noexcept;

  /// True if the hand holds the device and neither a trip, a stale device nor a silent program forbids forces.
  bool enabled() const noexcept { return enabled_; }
  /// Latches a trip from outside, e.g. from the renderer. The first trip is kept; while disarmed no trip is latched. A
  /// trip that requires a cut cuts the force in any case.
  void trip(const Trip& trip) noexcept;

  /// The device was told to give no force by another way than `limit`. The next tick follows a gap.
  void toldNothing() noexcept { told_nothing_ = true; }

  /// `resistance_n`: the force of the source. A value that is not finite trips.
  LimitedForce limit(double resistance_n, const LimitSettings& limits) noexcept;

  const Trip& tripped() const noexcept { return trip_; }
  /// Used share of the thermal budget, [0, 1]. At 1 the motors must rest.
  double thermalShare() const noexcept { return thermal_.share(); }
  /// The load of the motors after the last force has ended, if no tick follows.
  ThermalBudget thermal() const noexcept;
  /// How many times a force, or a hand that held the device, restarted after a gap.
  std::uint64_t restarts() const noexcept { return restarts_; }
  /// Speed of the hand as the velocity guard estimates it, mm/s, positive inwards.
  double speedMmS() const noexcept { return velocity_.speedMmS(); }
  /// Energy W of the passivity guard, mJ; positive: taken from the hand.
  double energyMj() const noexcept { return passivity_.energyMj(); }

 private:
  void passTime(const SafetyInput& input, const LimitSettings& limits) noexcept;
  void heat(double elapsed_s, const LimitSettings& limits) noexcept;
  bool deviceLetGo(const SafetyInput& input, const LimitSettings& limits) noexcept;
  void beginAnew() noexcept;
  void arm(bool armed) noexcept;
  std::optional<bool> contact(const SafetyInput& input, const EnableSettings& enable) const noexcept;
  /// The trip that this tick requires; if there are several, the most fundamental one.
  Trip wrong(const SafetyInput& input, const LimitSettings& limits) const noexcept;
  void disable() noexcept;
  double asked(double resistance_n, const LimitSettings& limits, std::uint32_t& limited) noexcept;
  double released(const LimitSettings& limits) const noexcept;

  double hold_s_;
  bool running_ = false;  ///< true after the first tick
  bool armed_ = false;
  std::int64_t now_ns_ = 0;
  std::int64_t before_ns_ = 0;   ///< time of the tick before the last
  std::int64_t armed_ns_ = 0;    ///< time of arming
  double step_s_ = 0;            ///< length of this tick, limited for quantities that must not jump after a stall
  std::int64_t resumed_ns_ = 0;  ///< the first tick after the last stall of the servo
  bool late_ = false;            ///< the last tick came after a stall
  bool on_the_way_ = false;      ///< commands since the stall cannot have arrived yet
  bool told_nothing_ = false;
  bool in_gap_ = false;           ///< no command has reached the device since it dropped the force
  bool fading_from_gap_ = false;  ///< the present fade-in follows a gap
  std::uint64_t restarts_ = 0;
  std::optional<double> sample_age_s_;
  bool fresh_ = false;  ///< a sample exists and is fresh enough for a force

  EnableSwitch switch_;
  VelocityGuard velocity_;
  ThermalBudget thermal_;
  PassivityGuard passivity_;

  Trip trip_;
  bool cut_ = false;      ///< a cause in this tick allows no fade
  bool engaged_ = false;  ///< the hand was slow enough at least once since the press
  bool enabled_ = false;
  bool gui_silent_ = false;

  double force_n_ = 0;     ///< the last output
  double faded_in_s_ = 0;  ///< time enabled since the fade-in began
  double released_n_ = 0;  ///< size of the force at the release
  std::int64_t released_ns_ = 0;
  double fresh_n_ = 0;  ///< size of the force when the device's sample was last fresh
};

}  // namespace tactus::haptics
