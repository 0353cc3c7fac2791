#include "core/haptics/safety/limit_settings.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace tactus::haptics {
namespace {

DeviceInfo touch() {
  DeviceInfo info;
  info.max_force_n = 3.3;
  info.continuous_force_n = 0.88;
  info.delay_s = 0.002;
  return info;
}

std::string message(const base::Result<void>& result) { return result ? "fine" : result.error().message(); }

TEST(LimitSettings, DefaultsAreThoseOfTheTable) {
  const LimitSettings limits = LimitSettings::forDevice(touch());
  EXPECT_EQ(limits.force_cap_n, 2);
  EXPECT_EQ(limits.continuous_force_n, 0.88);
  EXPECT_EQ(limits.thermal_window_s, 60);
  EXPECT_EQ(limits.slew_n_s, 250);
  EXPECT_EQ(limits.release_slew_n_s, 500);
  EXPECT_EQ(limits.fade_in_s, 1);
  EXPECT_EQ(limits.release_s, 0.03);
  EXPECT_EQ(limits.inward_guard_mm_s, 600);
  EXPECT_EQ(limits.outward_guard_mm_s, 400);
  EXPECT_EQ(limits.stale_decay_s, 0.005);
  EXPECT_EQ(limits.stale_zero_s, 0.02);
  EXPECT_EQ(limits.stale_trip_s, 0.1);
  EXPECT_EQ(limits.write_trip_s, 0.05);
  EXPECT_EQ(limits.gui_silent_s, 0.5);
  EXPECT_EQ(limits.stimulus_hold_s, 3);
  EXPECT_EQ(limits.loop_delay_s, 0.002);
}

TEST(LimitSettings, TheDeviceLowersThemAndNeverRaisesThem) {
  DeviceInfo info = touch();
  info.max_force_n = 1.5;
  info.continuous_force_n = 0.4;
  EXPECT_EQ(LimitSettings::forDevice(info).force_cap_n, 1.5);
  EXPECT_EQ(LimitSettings::forDevice(info, true).force_cap_n, 1.5);
  EXPECT_EQ(LimitSettings::forDevice(info).continuous_force_n, 0.4);
  info.max_force_n = 12;
  info.continuous_force_n = 8;
  EXPECT_EQ(LimitSettings::forDevice(info).force_cap_n, 2);
  EXPECT_EQ(LimitSettings::forDevice(info, true).force_cap_n, 3);
  EXPECT_EQ(LimitSettings::forDevice(info).continuous_force_n, 0.88);
}

TEST(LimitSettings, ADeviceThatCannotSayItsForceGetsNone) {
  DeviceInfo info;
  EXPECT_EQ(LimitSettings::forDevice(info).force_cap_n, 0);
  info.max_force_n = std::nan("");
  info.continuous_force_n = std::nan("");
  EXPECT_EQ(LimitSettings::forDevice(info).force_cap_n, 0);
  EXPECT_EQ(LimitSettings::forDevice(info).continuous_force_n, 0);
  info.max_force_n = -1;
  EXPECT_EQ(LimitSettings::forDevice(info).force_cap_n, 0);
}

TEST(LimitSettings, DefaultsOfEachDevicePassTheCheck) {
  for (const double force_n : {0.0, 0.5, 2.0, 3.3, 12.0}) {
    for (const bool expert : {false, true}) {
      DeviceInfo info = touch();
      info.max_force_n = force_n;
      EXPECT_EQ(message(check(LimitSettings::forDevice(info, expert), info, expert)), "fine");
    }
  }
}

TEST(LimitSettings, RefusesALooserLimitAndSaysWhy) {
  const DeviceInfo info = touch();
  LimitSettings limits = LimitSettings::forDevice(info);
  limits.force_cap_n = 2.5;
  EXPECT_EQ(message(check(limits, info)),
            "force_cap_n: found 2.5, wanted a number from 0 to 2, or 3 for an expert who asked");
  EXPECT_EQ(message(check(limits, info, true)), "fine");
  limits.force_cap_n = 3.1;
  EXPECT_EQ(message(check(limits, info, true)), "force_cap_n: found 3.1, wanted a number from 0 to 3");

  DeviceInfo weak = info;
  weak.max_force_n = 1.5;
  EXPECT_EQ(message(check(limits, weak)),
            "force_cap_n: found 3.1, wanted a number from 0 to 1.5, the largest force of this device");

  limits = LimitSettings::forDevice(info);
  limits.continuous_force_n = 1;
  EXPECT_EQ(message(check(limits, info)),
            "continuous_force_n: found 1, wanted a number from 0 to 0.88, the continuous rating of this device");
  DeviceInfo unrated = info;
  unrated.continuous_force_n.reset();
  EXPECT_EQ(message(check(limits, unrated)),
            "continuous_force_n: found 1, wanted a number from 0 to 0.88, as the rating of this device is not known");

  limits = LimitSettings::forDevice(info);
  limits.release_s = 0.05;
  EXPECT_EQ(message(check(limits, info)), "release_s: found 0.05, wanted a number from 0.006 to 0.03");
  limits = LimitSettings::forDevice(info);
  limits.slew_n_s = std::nan("");
  EXPECT_EQ(message(check(limits, info)), "slew_n_s: found nan, wanted a number from 10 to 250");
}

TEST(LimitSettings, AStricterLimitIsFine) {
  const DeviceInfo info = touch();
  LimitSettings limits = LimitSettings::forDevice(info);
  limits.force_cap_n = 0.5;
  limits.slew_n_s = 100;
  limits.fade_in_s = 2;
  limits.outward_guard_mm_s = 300;
  EXPECT_EQ(message(check(limits, info)), "fine");
}

TEST(EnableSettings, RefusesASwitchThatNobodyCanPress) {
  EnableSettings enable;
  EXPECT_EQ(message(check(enable)), "fine");
  enable.button_mask = 0;
  EXPECT_EQ(message(check(enable)), "button_mask: found 0, wanted at least one button");
  enable.kind = EnableKind::kPedal;
  EXPECT_EQ(message(check(enable)), "fine");
  enable.press_debounce_s = 0;
  EXPECT_EQ(message(check(enable)), "press_debounce_s: found 0, wanted a number from 0.01 to 0.1");
  enable = {};
  enable.start_zone_mm = 0;
  EXPECT_EQ(message(check(enable)), "start_zone_mm: found 0, wanted a number above 0");
  enable = {};
  enable.release_zone_mm = std::nan("");
  EXPECT_EQ(message(check(enable)), "release_zone_mm: found nan, wanted a finite number");
}

TEST(LimitSettings, NumbersThatAreNoneOrBelowZeroAreNotWellFormed) {
  EXPECT_TRUE(wellFormed(LimitSettings{}));
  LimitSettings limits;
  limits.servo_trip_s = 1e6;  // looser than a person may set, but a limit
  EXPECT_TRUE(wellFormed(limits));
  for (double LimitSettings::*member : {&LimitSettings::force_cap_n, &LimitSettings::continuous_force_n,
                                        &LimitSettings::release_slew_n_s, &LimitSettings::stimulus_hold_s}) {
    for (const double bad : {std::nan(""), -1.0, HUGE_VAL}) {
      limits = {};
      limits.*member = bad;
      EXPECT_FALSE(wellFormed(limits)) << bad;
    }
  }
}

TEST(EnableSettings, NumbersThatAreNoneAreNotWellFormed) {
  EnableSettings enable;
  enable.start_zone_mm = 5;
  EXPECT_TRUE(wellFormed(enable));
  enable.start_zone_mm = std::nan("");
  EXPECT_FALSE(wellFormed(enable));
  enable = {};
  enable.release_zone_mm = -HUGE_VAL;
  EXPECT_FALSE(wellFormed(enable));
  enable = {};
  enable.press_debounce_s = -0.001;
  EXPECT_FALSE(wellFormed(enable));
}

}  // namespace
}  // namespace tactus::haptics
