// Trips are latched and cleared in one order, and what cuts ends a force that still fades.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/haptics/safety/safety.h"

#include "tests/core/haptics/safety/safety_loop.h"

namespace tactus::haptics {
namespace {

TEST(Safety, AForceThatIsNoNumberTripsAndIsNeverPassedOn) {
  for (const double bad_n : {std::nan(""), std::numeric_limits<double>::infinity(), -1e308 * 10}) {
    SafetyLoop loop;
    loop.toFullForce();
    loop.asked_n = bad_n;
    EXPECT_EQ(loop.tick(), 0);
    EXPECT_EQ(loop.safety.tripped().cause, TripCause::kForceNotFinite);
    EXPECT_EQ(loop.safety.tripped().time_ns, loop.now_ns);
    EXPECT_FALSE(loop.safety.enabled());
    loop.asked_n = 1;
    EXPECT_EQ(loop.ticks(1000), 0);
  }
}

TEST(Safety, ATripIsClearedByDisarmingLettingGoAndArmingInThisOrder) {
  SafetyLoop loop;
  loop.toFullForce();
  loop.input.stop = true;
  EXPECT_EQ(loop.tick(), 0);  // Stop cuts
  EXPECT_EQ(loop.safety.tripped().cause, TripCause::kStopped);
  loop.press(false);
  loop.ticks(50);
  loop.press(true);
  EXPECT_EQ(loop.ticks(50), 0);
  EXPECT_TRUE(loop.safety.tripped());
  // Armed again without letting go: the trip stays.
  loop.input.armed = false;
  loop.ticks(10);
  loop.input.armed = true;
  EXPECT_EQ(loop.ticks(50), 0);
  loop.press(false);
  loop.ticks(10);
  EXPECT_TRUE(loop.safety.tripped());
  loop.input.armed = false;
  loop.ticks(10);
  EXPECT_TRUE(loop.safety.tripped());  // still to be read
  loop.input.armed = true;
  loop.ticks(2);
  EXPECT_FALSE(loop.safety.tripped());
  loop.press(true);
  loop.ticks(515);
  EXPECT_NEAR(loop.out.force_n, 0.5, 1e-9);  // with a new fade-in
}

TEST(Safety, TheFirstTripStays) {
  SafetyLoop loop;
  loop.toFullForce();
  loop.safety.trip({TripCause::kRenderer, 2, 0, 0});
  loop.safety.trip({TripCause::kStopped, 0, 0, 0});
  loop.input.stop = true;
  loop.tick();
  EXPECT_EQ(loop.safety.tripped().cause, TripCause::kRenderer);
  EXPECT_EQ(loop.safety.tripped().value, 2);
}

/// 0.8 N that fade because the hand was too fast, 3 ms of the 30 ms on.
SafetyLoop fading() {
  SafetyLoop loop;
  loop.asked_n = 0.8;
  loop.input.follows_motion = false;
  loop.toFullForce();
  while (!loop.safety.tripped()) {
    loop.input.position_mm += 0.8;
    loop.tick();
  }
  loop.ticks(2);
  EXPECT_EQ(loop.safety.tripped().cause, TripCause::kTooFastInwards);
  EXPECT_NEAR(loop.out.force_n, 0.8 * 27 / 30, 1e-9);
  return loop;
}

void expectCutAndFirstCause(SafetyLoop& loop) {
  EXPECT_EQ(loop.tick(), 0);
  EXPECT_EQ(loop.safety.tripped().cause, TripCause::kTooFastInwards);
  EXPECT_EQ(loop.ticks(50), 0);
}

TEST(Safety, StopCutsAForceThatFades) {
  SafetyLoop loop = fading();
  loop.input.stop = true;
  expectCutAndFirstCause(loop);
}

TEST(Safety, APositionOrForceThatIsNoneCutsAForceThatFades) {
  SafetyLoop nowhere = fading();
  nowhere.input.position_mm = std::nan("");
  expectCutAndFirstCause(nowhere);
  SafetyLoop senseless = fading();
  senseless.asked_n = std::nan("");
  expectCutAndFirstCause(senseless);
}

TEST(Safety, ALostOrFailedDeviceCutsAForceThatFades) {
  for (const DeviceFault fault : {DeviceFault::kLost, DeviceFault::kNotCalibrated, DeviceFault::kSwitchedOff}) {
    SafetyLoop loop = fading();
    loop.device.fault = fault;
    expectCutAndFirstCause(loop);
  }
  SafetyLoop warm = fading();
  warm.device.fault = DeviceFault::kWarmMotors;
  EXPECT_NEAR(warm.tick(), 0.8 * 26 / 30, 1e-9);  // the device is sound: the fade continues
}

TEST(Safety, StopCutsTheFadeOfADisarmedLayer) {
  SafetyLoop loop;
  loop.toFullForce();
  loop.input.armed = false;
  loop.ticks(3);
  ASSERT_NEAR(loop.out.force_n, 27.0 / 30, 1e-9);
  loop.input.stop = true;
  EXPECT_EQ(loop.tick(), 0);
  EXPECT_FALSE(loop.safety.tripped());
  EXPECT_EQ(loop.ticks(50), 0);
}

TEST(Safety, ACutWhileDisarmedHoldsNothingBackLater) {
  SafetyLoop loop;
  loop.toFullForce();
  loop.input.armed = false;
  loop.input.stop = true;
  loop.tick();
  loop.input.armed = true;  // still pressed
  EXPECT_EQ(loop.ticks(50), 0);
  loop.press(false);
  loop.ticks(2);
  loop.press(true);
  EXPECT_EQ(loop.ticks(1100), 1);
}

TEST(Safety, ArmingAndPressingDuringAFadeBeginsANewFadeIn) {
  SafetyLoop loop;
  loop.toFullForce();
  loop.input.armed = false;
  loop.press(false);
  loop.ticks(3);
  loop.input.armed = true;
  loop.tick();
  loop.press(true);
  for (int i = 5; i < 20; ++i) ASSERT_NEAR(loop.tick(), 1 - i / 30.0, 1e-9);
  // Held: what is left goes with the slew toward zero, to a force that fades in from nothing.
  EXPECT_NEAR(loop.tick(), 0.001, 1e-9);
  EXPECT_TRUE(loop.safety.enabled());
  loop.ticks(9);
  EXPECT_NEAR(loop.out.force_n, 0.010, 1e-9);
}

}  // namespace
}  // namespace tactus::haptics
