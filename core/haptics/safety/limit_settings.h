// The limits that stand between any force and the hand. The table of defaults: docs/servo.md.
#pragma once

#include <cstdint>
#include <optional>

#include "core/haptics/device/device.h"

namespace tactus::haptics {

/// How the hand says "I hold it": a squeezed switch spoils the feel (paper, Section 5.4), so the study chooses.
enum class EnableKind : std::uint8_t {
  kButton,  ///< a button of the device, held
  kPedal,   ///< a pedal, held; it arrives as ServoOrders::pedal... of the program
  kKey,     ///< a key of the computer, held
  kLatch,   ///< a press switches on; leaving the release zone outwards, or another press, switches off
};

struct EnableSettings {
  EnableKind kind = EnableKind::kButton;
  std::uint32_t button_mask = 1;        ///< which buttons of the device count
  double press_debounce_s = 0.015;      ///< a press counts after this time, a release at once
  double release_zone_mm = -20;         ///< kLatch: axis positions further out than this let go
  std::optional<double> start_zone_mm;  ///< a press counts only within this distance of axis position 0
};

/// Each member is a default of the design's table; what a change does is said beside it.
struct LimitSettings {
  double force_cap_n = 2.0;          ///< [0, 3]: no force is larger; above 2 only for an expert who asked
  double continuous_force_n = 0.88;  ///< rms over `thermal_window_s` stays below; larger warms the motors
  double thermal_window_s = 60;
  double slew_n_s = 250;            ///< away from zero; larger is felt as a click
  double release_slew_n_s = 500;    ///< toward zero
  double fade_in_s = 1;             ///< once per arming, never per stroke
  double release_s = 0.03;          ///< after letting go the force is zero
  double inward_guard_mm_s = 600;   ///< faster than this away from the person trips
  double outward_guard_mm_s = 400;  ///< faster than this toward the person trips
  bool guard_velocity = true;       ///< off in the speed experiment, where there is no force
  double stale_decay_s = 0.005;     ///< a device sample older than this: the force decays (time constant 10 ms)
  double stale_zero_s = 0.020;      ///< older than this: zero
  double stale_trip_s = 0.100;      ///< older than this: latched trip
  double write_trip_s = 0.050;      ///< no force reached the device for so long: latched trip
  double servo_trip_s = 0.100;      ///< the servo itself missed ticks for so long: latched trip
  double gui_silent_s = 0.5;        ///< the program's heartbeat is older than this: zero
  double loop_delay_s = 0.001;      ///< of the device; the passivity guard pairs force and motion with it
  double stimulus_hold_s = 3;       ///< a stimulus above the continuous rating is held no longer

  /// The defaults with the device's own maximum and continuous rating where they are lower.
  /// `expert`: force cap up to 3 N instead of 2 N.
  static LimitSettings forDevice(const DeviceInfo& info, bool expert = false);
};

/// Whether a person may set these limits for this device: each may be stricter than its default, none looser; the force
/// cap at most the device's maximum and, unless `expert`, 2 N (else 3 N); the continuous force at most the device's
/// rating. The error names the limit, what was found and what is allowed. Real-time safe: no.
base::Result<void> check(const LimitSettings& limits, const DeviceInfo& info, bool expert = false);
/// The same for the switch: a button without a mask, a debounce outside 10 to 100 ms, zones that are none.
base::Result<void> check(const EnableSettings& enable);

/// What no part of the program may order, expert or test: a limit or a debounce that is not finite or below 0 (a slew
/// of NaN would limit nothing), a zone that is not finite. Thread: any.
bool wellFormed(const LimitSettings& limits) noexcept;
bool wellFormed(const EnableSettings& enable) noexcept;

}  // namespace tactus::haptics
