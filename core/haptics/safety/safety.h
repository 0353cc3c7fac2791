// The safety layer: the last thing between a force and the device. It knows nothing of models.
#pragma once

#include <cstdint>
#include <optional>

#include "core/haptics/device/device.h"
#include "core/haptics/safety/enable_switch.h"
#include "core/haptics/safety/limit_bit.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/safety/passivity_guard.h"
#include "core/haptics/safety/thermal_budget.h"
#include "core/haptics/safety/trip.h"
#include "core/haptics/safety/velocity_guard.h"

namespace tactus::haptics {

/// What the layer is told at a tick, before any source is asked.
struct SafetyInput {
  std::int64_t now_ns = 0;
  double position_mm = 0;               ///< along the insertion axis
  const DeviceState* device = nullptr;  ///< null like a device without a sample; it must keep `written_ns`
  bool armed = false;
  bool pedal = false;             ///< pedal or key of the program is down
  bool stop = false;              ///< Stop was pressed since the last tick
  std::int64_t heartbeat_ns = 0;  ///< last sign of life of the program; 0: none is expected
  /// Whether the source's force follows the motion of the hand (insertion). A force that does not (a stimulus) cannot
  /// feed a vibration, however much work it does, and the passivity guard leaves it alone.
  bool follows_motion = true;
  /// Positions mean something else than at the last tick (another axis): no motion lies between the two.
  bool another_axis = false;
  bool let_go = false;  ///< the press is spent: the force fades like after a release, until the hand presses again
};

struct LimitedForce {
  double force_n = 0;         ///< resistance along the axis
  std::uint32_t limited = 0;  ///< LimitBit
};

/// Two calls per tick: `begin` decides whether the hand holds the device and whether anything trips; `limit` takes the
/// source's force down to what is allowed. Order of the chain: finite, passivity guard, cap and thermal budget,
/// fade-in, slew, stale device, release. Docs: docs/servo.md, "Limits".
///
/// A trip is latched while armed: zero force until disarmed, let go, and armed again, in this order. Where the force
/// can no longer be trusted to be felt or answered it is cut in one tick (force or position not finite, device lost or
/// silent, write stuck, servo late, device without calibration, switched off or failed, Stop); where position and
/// device are sound it fades within `release_s` like a release, because a cut is felt as a kick of its own (velocity
/// guard, renderer, warm motors, a force that the device limited). The first cause stays, but whatever calls for a cut
/// later ends any force that still fades, armed or not.
/// A device holds a command for its `hold_s`. After a longer gap, because the servo stood still or because commands did
/// not arrive, the force in the hand is 0 whatever was asked for last: the layer goes on from 0, with a new fade-in and
/// a new energy count (kLimitedByGap).
/// Plain state, copyable; time comes in with the input.
/// Thread: servo. Real-time safe: yes.
class Safety {
 public:
  /// `hold_s` as DeviceInfo has it; `thermal`: what the motors have given so far.
  explicit Safety(double hold_s = DeviceInfo{}.hold_s, const ThermalBudget& thermal = {}) noexcept
      : hold_s_(hold_s), thermal_(thermal) {}

  void begin(const SafetyInput& input, const EnableSettings& enable, const LimitSettings& limits) noexcept;

  /// The hand holds the device and no trip, no stale device and no silent program forbids forces.
  bool enabled() const noexcept { return enabled_; }
  /// Latches a trip of somebody else, e.g. of the renderer; the first one stays, and while disarmed none is latched.
  /// One that calls for a cut cuts in any case.
  void trip(const Trip& trip) noexcept;

  /// The device was told to give no force, by another way than `limit`: the next tick follows a gap.
  void toldNothing() noexcept { told_nothing_ = true; }

  /// `resistance_n` as the source asks for it. Not finite trips.
  LimitedForce limit(double resistance_n, const LimitSettings& limits) noexcept;

  const Trip& tripped() const noexcept { return trip_; }
  /// Share of the thermal budget in use, [0, 1]; 1: the device rests.
  double thermalShare() const noexcept { return thermal_.share(); }
  /// What the motors have given once the last force is over, should no tick follow.
  ThermalBudget thermal() const noexcept;
  /// How often a force, or a hand that held the device, began anew after a gap.
  std::uint64_t restarts() const noexcept { return restarts_; }
  /// Speed of the hand as the guard sees it, mm/s, inwards positive.
  double speedMmS() const noexcept { return velocity_.speedMmS(); }
  /// Energy that the passivity guard sees, mJ; positive: taken from the hand.
  double energyMj() const noexcept { return passivity_.energyMj(); }

 private:
  void passTime(const SafetyInput& input, const LimitSettings& limits) noexcept;
  void heat(double elapsed_s, const LimitSettings& limits) noexcept;
  bool deviceLetGo(const SafetyInput& input, const LimitSettings& limits) noexcept;
  void beginAnew() noexcept;
  void arm(bool armed) noexcept;
  std::optional<bool> contact(const SafetyInput& input, const EnableSettings& enable) const noexcept;
  /// The trip that this tick calls for, the most fundamental one first.
  Trip wrong(const SafetyInput& input, const LimitSettings& limits) const noexcept;
  void disable() noexcept;
  double asked(double resistance_n, const LimitSettings& limits, std::uint32_t& limited) noexcept;
  double released(const LimitSettings& limits) const noexcept;

  double hold_s_;
  bool running_ = false;  ///< there was a tick
  bool armed_ = false;
  std::int64_t now_ns_ = 0;
  std::int64_t before_ns_ = 0;   ///< the tick before
  std::int64_t armed_ns_ = 0;    ///< since when
  double step_s_ = 0;            ///< length of this tick for whatever must not jump after a stall
  std::int64_t resumed_ns_ = 0;  ///< the first tick after the servo last stood still
  bool late_ = false;            ///< the last tick came after a standstill
  bool on_the_way_ = false;      ///< commands since then cannot have arrived yet
  bool told_nothing_ = false;
  bool in_gap_ = false;           ///< no command has reached the device since it let go
  bool fading_from_gap_ = false;  ///< the present fade-in is that after a gap
  std::uint64_t restarts_ = 0;
  std::optional<double> sample_age_s_;
  bool fresh_ = false;  ///< there is a sample, and it is young enough for a force

  EnableSwitch switch_;
  VelocityGuard velocity_;
  ThermalBudget thermal_;
  PassivityGuard passivity_;

  Trip trip_;
  bool cut_ = false;      ///< something in this tick allows no fade
  bool engaged_ = false;  ///< since the press the hand was slow enough once
  bool enabled_ = false;
  bool gui_silent_ = false;

  double force_n_ = 0;     ///< the last output
  double faded_in_s_ = 0;  ///< time enabled since the fade-in began
  double released_n_ = 0;  ///< size of the force when it was let go
  std::int64_t released_ns_ = 0;
  double fresh_n_ = 0;  ///< size of the force when the device's sample was last fresh
};

}  // namespace tactus::haptics
