// What the safety layer leaves of a force: fade-in, cap, slew, release, thermal budget.
#include "core/haptics/safety/safety.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "tests/core/haptics/safety/safety_loop.h"

namespace tactus::haptics {
namespace {

TEST(Safety, GivesNothingUntilArmedAndHeld) {
  SafetyLoop loop;
  EXPECT_EQ(loop.ticks(100), 0);
  EXPECT_TRUE(loop.limited(kLimitedByRelease));
  loop.input.armed = true;
  EXPECT_EQ(loop.ticks(100), 0);
  loop.press(true);
  EXPECT_EQ(loop.ticks(15), 0);
  EXPECT_GT(loop.ticks(10), 0);
  EXPECT_TRUE(loop.safety.enabled());
}

TEST(Safety, FadesInOnceForOneSecondOfHolding) {
  SafetyLoop loop;
  loop.input.armed = true;
  loop.ticks(2);
  loop.press(true);
  loop.ticks(15);
  for (int i = 1; i <= 500; ++i) ASSERT_NEAR(loop.tick(), 0.001 * i, 1e-9);
  EXPECT_TRUE(loop.limited(kLimitedByFadeIn));
  // A pause does not count, and the next stroke continues where this one was.
  loop.press(false);
  EXPECT_EQ(loop.ticks(5000), 0);
  loop.press(true);
  EXPECT_EQ(loop.ticks(15), 0);
  loop.ticks(3);
  EXPECT_NEAR(loop.out.force_n, 0.503, 1e-9);
  loop.ticks(600);
  EXPECT_EQ(loop.out.force_n, 1);
  EXPECT_EQ(loop.out.limited, 0U);
}

TEST(Safety, CapsAndSlewsInBothDirections) {
  SafetyLoop loop;
  loop.asked_n = 0;
  loop.toFullForce();
  loop.asked_n = 5;
  for (int i = 1; i <= 8; ++i) ASSERT_NEAR(loop.tick(), 0.25 * i, 1e-12);  // 250 N/s
  EXPECT_EQ(loop.tick(), 2);
  EXPECT_TRUE(loop.limited(kLimitedByCap));
  EXPECT_FALSE(loop.limited(kLimitedBySlew));
  loop.asked_n = 0.9;
  EXPECT_NEAR(loop.tick(), 1.5, 1e-12);  // 500 N/s
  EXPECT_TRUE(loop.limited(kLimitedBySlew));
  EXPECT_NEAR(loop.tick(), 1.0, 1e-12);
  EXPECT_NEAR(loop.tick(), 0.9, 1e-12);
  loop.asked_n = -5;
  EXPECT_NEAR(loop.tick(), 0.4, 1e-12);
  EXPECT_NEAR(loop.tick(), -0.05, 1e-12);  // 0.8 of the tick to zero, 0.2 of it at 250 N/s
  EXPECT_NEAR(loop.tick(), -0.3, 1e-12);
}

TEST(Safety, AStallDoesNotMakeTheForceJump) {
  SafetyLoop loop;
  loop.asked_n = 0;
  loop.toFullForce();
  loop.asked_n = 2;
  EXPECT_NEAR(loop.tick(40), 0.5, 1e-12);  // as after 2 ms
}

TEST(Safety, TheForceIsGoneThirtyMillisecondsAfterTheRelease) {
  for (const double force_n : {0.2, 2.0, 3.0, -3.0}) {
    SafetyLoop loop;
    loop.limits.force_cap_n = 3;
    loop.input.follows_motion = false;
    loop.asked_n = force_n;
    loop.toFullForce();
    ASSERT_EQ(loop.out.force_n, force_n);
    loop.press(false);
    for (int i = 1; i < 30; ++i) ASSERT_NEAR(loop.tick(), force_n * (1 - i / 30.0), 1e-9) << i;
    EXPECT_EQ(loop.tick(), 0);
  }
}

TEST(Safety, ASpentPressFadesAndWaitsForTheNext) {
  SafetyLoop loop;
  loop.toFullForce();
  loop.input.let_go = true;
  EXPECT_NEAR(loop.tick(), 29.0 / 30, 1e-9);
  loop.input.let_go = false;
  loop.ticks(28);
  EXPECT_NEAR(loop.out.force_n, 1.0 / 30, 1e-9);
  EXPECT_EQ(loop.ticks(500), 0);
  EXPECT_FALSE(loop.safety.tripped());
  loop.press(false);
  loop.ticks(2);
  loop.press(true);
  EXPECT_EQ(loop.ticks(30), 1);
}

TEST(Safety, APressOnADeviceThatIsSilentWhenStillIsEnabled) {
  SafetyLoop loop;
  loop.input.armed = true;
  for (int i = 0; i < 100; ++i) loop.input.position_mm -= 0.45, loop.tick();  // 450 mm/s, and a dead stop
  loop.sampling = false;
  const auto renewed = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      loop.device.time_ns = loop.now_ns + 1'000'000;
      loop.tick();
    }
  };
  renewed(100);
  EXPECT_EQ(loop.safety.speedMmS(), 0);
  loop.press(true);
  renewed(20);
  EXPECT_TRUE(loop.safety.enabled());
}

TEST(Safety, TheThermalBudgetFadesTheForceAndSaysSo) {
  SafetyLoop loop;
  loop.asked_n = 2;
  loop.input.follows_motion = false;
  loop.toFullForce();
  EXPECT_FALSE(loop.limited(kLimitedByThermal));
  loop.ticks(30000);
  EXPECT_TRUE(loop.limited(kLimitedByThermal));
  EXPECT_LT(loop.out.force_n, 0.1);
  EXPECT_GT(loop.safety.thermalShare(), 0.99);
  EXPECT_LE(loop.safety.thermalShare(), 1);
}

TEST(Safety, AForceThatFollowsNoMotionIsNotThePassivityGuardsConcern) {
  for (const bool follows : {false, true}) {
    SafetyLoop loop;
    loop.asked_n = 1;
    loop.input.follows_motion = follows;
    loop.toFullForce();
    bool guarded = false;
    for (int i = 0; i < 200; ++i) {  // the hand gives way at 100 mm/s: 20 mJ
      loop.input.position_mm -= 0.1;
      loop.tick();
      guarded = guarded || loop.limited(kLimitedByPassivity);
    }
    EXPECT_EQ(guarded, follows);
  }
}

TEST(Safety, IsPlainState) {
  SafetyLoop one;
  one.toFullForce();
  SafetyLoop two = one;
  for (int i = 0; i < 200; ++i) {
    one.asked_n = two.asked_n = 1 + std::sin(0.1 * i);
    ASSERT_EQ(one.tick(), two.tick());
  }
}

}  // namespace
}  // namespace tactus::haptics
