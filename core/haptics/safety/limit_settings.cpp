#include "core/haptics/safety/limit_settings.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/text.h"
#include "core/haptics/safety/passivity_guard.h"

namespace tactus::haptics {
namespace {

constexpr double kExpertCapN = 3;

/// What may be set. A limit may be made stricter than its default, never looser.
struct Field {
  const char* name;
  double LimitSettings::*member;
  double min;
  double max;
};

constexpr Field kFields[] = {
    {"thermal_window_s", &LimitSettings::thermal_window_s, 10, 600},
    {"slew_n_s", &LimitSettings::slew_n_s, 10, 250},
    {"release_slew_n_s", &LimitSettings::release_slew_n_s, 200, 500},
    {"fade_in_s", &LimitSettings::fade_in_s, 1, 10},
    {"release_s", &LimitSettings::release_s, 0.006, 0.03},
    {"inward_guard_mm_s", &LimitSettings::inward_guard_mm_s, 20, 600},
    {"outward_guard_mm_s", &LimitSettings::outward_guard_mm_s, 20, 400},
    {"stale_decay_s", &LimitSettings::stale_decay_s, 0.002, 0.005},
    {"stale_zero_s", &LimitSettings::stale_zero_s, 0.015, 0.020},
    {"stale_trip_s", &LimitSettings::stale_trip_s, 0.020, 0.100},
    {"write_trip_s", &LimitSettings::write_trip_s, 0.010, 0.050},
    {"servo_trip_s", &LimitSettings::servo_trip_s, 0.010, 0.100},
    {"gui_silent_s", &LimitSettings::gui_silent_s, 0.1, 0.5},
    {"loop_delay_s", &LimitSettings::loop_delay_s, 0, PassivityGuard::kLongestDelayS},
    {"stimulus_hold_s", &LimitSettings::stimulus_hold_s, 0, 3},
};

/// A device that says nothing sensible of its force gets none.
double lower(double limit, double device) { return device >= 0 ? std::min(limit, device) : 0; }

bool size(double value) noexcept { return std::isfinite(value) && value >= 0; }

base::Result<void> within(const char* name, double value, double min, double max, const char* why) {
  if (value >= min && value <= max) return {};
  return base::fail(base::ErrorCode::kValue, name, base::formatNumber(value),
                    "a number from " + base::formatNumber(min) + " to " + base::formatNumber(max) + why);
}

}  // namespace

LimitSettings LimitSettings::forDevice(const DeviceInfo& info, bool expert) {
  LimitSettings limits;
  limits.force_cap_n = lower(expert ? kExpertCapN : limits.force_cap_n, info.max_force_n);
  if (info.continuous_force_n) limits.continuous_force_n = lower(limits.continuous_force_n, *info.continuous_force_n);
  limits.loop_delay_s = std::clamp(info.delay_s, 0.0, PassivityGuard::kLongestDelayS);
  return limits;
}

base::Result<void> check(const LimitSettings& limits, const DeviceInfo& info, bool expert) {
  const double cap_n = LimitSettings::forDevice(info, expert).force_cap_n;
  const bool by_device = cap_n == info.max_force_n;
  const char* why = by_device ? ", the largest force of this device" : expert ? "" : ", or 3 for an expert who asked";
  if (auto ok = within("force_cap_n", limits.force_cap_n, 0, cap_n, why); !ok) return ok;
  const double rating_n = info.continuous_force_n.value_or(LimitSettings{}.continuous_force_n);
  why = info.continuous_force_n ? ", the continuous rating of this device"
                                : ", as the rating of this device is not known";
  if (auto ok = within("continuous_force_n", limits.continuous_force_n, 0, rating_n, why); !ok) return ok;
  for (const Field& field : kFields)
    if (auto ok = within(field.name, limits.*field.member, field.min, field.max, ""); !ok) return ok;
  return {};
}

base::Result<void> check(const EnableSettings& enable) {
  const bool with_button = enable.kind == EnableKind::kButton;
  if (with_button && enable.button_mask == 0)
    return base::fail(base::ErrorCode::kValue, "button_mask", "0", "at least one button");
  if (auto ok = within("press_debounce_s", enable.press_debounce_s, 0.010, 0.100, ""); !ok) return ok;
  if (!std::isfinite(enable.release_zone_mm))
    return base::fail(base::ErrorCode::kValue, "release_zone_mm", base::formatNumber(enable.release_zone_mm),
                      "a finite number");
  if (enable.start_zone_mm && !(*enable.start_zone_mm > 0))
    return base::fail(base::ErrorCode::kValue, "start_zone_mm", base::formatNumber(*enable.start_zone_mm),
                      "a number above 0");
  return {};
}

bool wellFormed(const LimitSettings& limits) noexcept {
  return size(limits.force_cap_n) && size(limits.continuous_force_n) &&
         std::all_of(std::begin(kFields), std::end(kFields),
                     [&](const Field& field) { return size(limits.*field.member); });
}

bool wellFormed(const EnableSettings& enable) noexcept {
  return size(enable.press_debounce_s) && std::isfinite(enable.release_zone_mm) &&
         (!enable.start_zone_mm || size(*enable.start_zone_mm));
}

}  // namespace tactus::haptics
