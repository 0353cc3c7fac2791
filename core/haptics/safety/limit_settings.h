// The limits between any force and the hand. Table of defaults: docs/servo.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/haptics/device/device.h"

namespace tactus::haptics {

// The limits that acted in a tick.

/// Bits of Sample::limited and LimitedForce::limited.
enum LimitBit : std::uint32_t {
  kLimitedByCap = 1u << 0,
  kLimitedBySlew = 1u << 1,
  kLimitedByFadeIn = 1u << 2,
  kLimitedByThermal = 1u << 3,
  kLimitedByPassivity = 1u << 4,
  kLimitedByStaleDevice = 1u << 5,
  kLimitedByGui = 1u << 6,
  kLimitedByRelease = 1u << 7,  ///< the hand has not enabled the force
  kLimitedByTrip = 1u << 8,
  kLimitedByStiffness = 1u << 9,  ///< the rendered stiffness is below the model's
  kLimitedByGap = 1u << 10,       ///< fade-in after a gap between commands longer than the device holds a force
};

/// Names of the bits in traces and reports, bit 0 first.
inline constexpr std::array<std::string_view, 11> kLimitNames = {
    "cap",     "slew", "fade_in",   "thermal",    "passivity", "stale_device", "program_silent",
    "release", "trip", "stiffness", "command_gap"};

/// The switch by which the user enables forces. A squeezed switch changes the feel (paper, Section 5.4), so the study
/// chooses.
enum class EnableKind : std::uint8_t {
  kButton,  ///< a button of the device, held
  kPedal,   ///< a pedal, held; the program reports it with Servo::pedal
  kKey,     ///< a key of the computer, held
  kLatch,   ///< a press switches on; leaving the release zone outwards, or another press, switches off
};

struct EnableSettings {
  EnableKind kind = EnableKind::kButton;
  std::uint32_t button_mask = 1;        ///< the buttons of the device that count
  double press_debounce_s = 0.015;      ///< a press counts after this time; a release counts at once
  double release_zone_mm = -20;         ///< kLatch: an axis position further out than this releases
  std::optional<double> start_zone_mm;  ///< a press counts only within this distance of axis position 0
};

/// The defaults are those of the table in docs/servo.md. The comments give the effect of a change.
struct LimitSettings {
  double force_cap_n = 2.0;          ///< [0, 3]: largest force; above 2 only on an expert's request
  double continuous_force_n = 0.88;  ///< largest rms over `thermal_window_s`; a larger one warms the motors
  double thermal_window_s = 60;
  double slew_n_s = 250;            ///< away from zero; a larger one is felt as a click
  double release_slew_n_s = 500;    ///< toward zero
  double fade_in_s = 1;             ///< once per arming, never per stroke
  double release_s = 0.03;          ///< time from the release of the switch to zero force
  double inward_guard_mm_s = 600;   ///< a faster motion away from the user trips
  double outward_guard_mm_s = 400;  ///< a faster motion toward the user trips
  bool guard_velocity = true;       ///< off in the speed experiment, which has no force
  double stale_decay_s = 0.005;     ///< age of a device sample above which the force decays (time constant 10 ms)
  double stale_zero_s = 0.020;      ///< age above which the force is zero
  double stale_trip_s = 0.100;      ///< age above which the servo trips
  double write_trip_s = 0.050;      ///< time without a force reaching the device above which the servo trips
  double servo_trip_s = 0.100;      ///< gap between ticks above which the servo trips
  double gui_silent_s = 0.5;        ///< age of the program's heartbeat above which the force is zero
  double loop_delay_s = 0.001;      ///< of the device; the passivity guard uses it to pair force and motion
  double stimulus_hold_s = 3;       ///< longest time for a stimulus above the continuous rating

  /// The defaults, with the maximum force and the continuous rating of the device if they are lower. `expert`: force
  /// cap up to 3 N instead of 2 N.
  static LimitSettings forDevice(const DeviceInfo& info, bool expert = false);
};

/// Checks the limits that a user sets for this device. A limit may be stricter than its default, not looser. The force
/// cap may be at most the device's maximum, and at most 2 N (3 N if `expert`). The continuous force may be at most the
/// device's rating. The error names the limit, the value and the allowed range. Real-time safe: no.
base::Result<void> check(const LimitSettings& limits, const DeviceInfo& info, bool expert = false);
/// Checks the settings of the switch. Returns an error for a button without a mask, a debounce outside 10 to 100 ms, or
/// invalid zones.
base::Result<void> check(const EnableSettings& enable);

/// The minimum for all callers, also tests and experts: limits and debounce are finite and >= 0, zones are finite. A
/// slew of NaN, for example, would limit nothing. Thread: any.
bool wellFormed(const LimitSettings& limits) noexcept;
bool wellFormed(const EnableSettings& enable) noexcept;

}  // namespace tactus::haptics
