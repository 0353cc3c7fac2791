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
  // A pause does not count, and the next stroke goes on where this one was.
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
  EXPECT_NEAR(warm.tick(), 0.8 * 26 / 30, 1e-9);  // the device is sound: the fade goes on
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

TEST(Safety, ADisarmedLayerDoesNotTrip) {
  SafetyLoop loop;
  loop.asked_n = std::nan("");
  loop.input.stop = true;
  loop.device.fault = DeviceFault::kLost;
  EXPECT_EQ(loop.ticks(10), 0);
  EXPECT_FALSE(loop.safety.tripped());
}

TEST(Safety, TooFastAHandTripsAndTheForceFadesLikeARelease) {
  for (const double sign : {1.0, -1.0}) {
    SafetyLoop loop;
    loop.asked_n = 1.5;
    loop.input.follows_motion = false;
    loop.toFullForce();
    int ms = 0;
    for (; ms < 30 && !loop.safety.tripped(); ++ms) {
      loop.input.position_mm += sign * 0.8;
      loop.tick();
    }
    EXPECT_LE(ms, 15);
    EXPECT_EQ(loop.safety.tripped().cause, sign > 0 ? TripCause::kTooFastInwards : TripCause::kTooFastOutwards);
    EXPECT_EQ(loop.safety.tripped().limit, sign > 0 ? 600 : 400);
    EXPECT_NEAR(loop.out.force_n, 1.5 * 29 / 30, 1e-9);
    loop.ticks(28);
    EXPECT_NEAR(loop.out.force_n, 1.5 / 30, 1e-9);
    EXPECT_EQ(loop.tick(), 0);
  }
}

TEST(Safety, TheVelocityGuardRestsWhileNobodyHoldsAndWhereItIsOff) {
  SafetyLoop loop;
  loop.toFullForce();
  loop.press(false);
  for (int i = 0; i < 100; ++i) loop.input.position_mm -= 0.9, loop.tick();  // back at 900 mm/s, button up
  EXPECT_FALSE(loop.safety.tripped());
  // A press in full motion waits until the hand is slow.
  loop.press(true);
  for (int i = 0; i < 100; ++i) loop.input.position_mm -= 0.9, loop.tick();
  EXPECT_FALSE(loop.safety.tripped());
  EXPECT_FALSE(loop.safety.enabled());
  loop.ticks(20);
  EXPECT_TRUE(loop.safety.enabled());
  loop.limits.guard_velocity = false;
  for (int i = 0; i < 100; ++i) loop.input.position_mm -= 0.9, loop.tick();
  EXPECT_TRUE(loop.safety.enabled());
}

TEST(Safety, AnotherAxisIsNoMotion) {
  SafetyLoop loop;
  loop.toFullForce();
  loop.input.position_mm = 300;
  loop.input.another_axis = true;
  loop.tick();
  loop.input.another_axis = false;
  loop.ticks(50);
  EXPECT_FALSE(loop.safety.tripped());
  EXPECT_EQ(loop.out.force_n, 1);
}

TEST(Safety, AStaleDeviceDecaysToZeroAndTrips) {
  SafetyLoop loop;
  loop.toFullForce();
  loop.sampling = false;
  EXPECT_EQ(loop.ticks(5), 1);
  double before_n = 1;
  for (int age_ms = 6; age_ms < 20; ++age_ms) {
    const double now_n = loop.tick();
    EXPECT_LE(now_n, std::exp(-(age_ms - 5) / 10.0) + 1e-4) << age_ms;
    EXPECT_LT(now_n, before_n);
    EXPECT_TRUE(loop.limited(kLimitedByStaleDevice));
    before_n = now_n;
  }
  EXPECT_TRUE(loop.safety.enabled());
  EXPECT_LT(before_n, 0.06);
  EXPECT_EQ(loop.tick(), 0);  // 20 ms
  EXPECT_FALSE(loop.safety.enabled());
  loop.ticks(80);
  EXPECT_FALSE(loop.safety.tripped());
  loop.tick();
  EXPECT_EQ(loop.safety.tripped().cause, TripCause::kDeviceSilent);
  EXPECT_NEAR(loop.safety.tripped().value, 0.101, 1e-9);
  EXPECT_EQ(loop.safety.tripped().limit, 0.1);
}

TEST(Safety, ADeviceThatComesBackInTimeGoesOn) {
  SafetyLoop loop;
  loop.toFullForce();
  loop.sampling = false;
  loop.ticks(60);
  loop.sampling = true;
  EXPECT_NEAR(loop.tick(), 0.25, 1e-12);  // no faster than the slew
  EXPECT_EQ(loop.ticks(3), 1);
}

TEST(Safety, ADeviceWithoutAnySampleTripsAfterArming) {
  SafetyLoop loop;
  loop.sampling = false;
  loop.input.armed = true;
  loop.ticks(101);
  EXPECT_FALSE(loop.safety.tripped());
  loop.tick();
  EXPECT_EQ(loop.safety.tripped().cause, TripCause::kDeviceSilent);
}

TEST(Safety, AWriteThatIsStuckTripsAndCuts) {
  SafetyLoop loop;
  loop.safety = Safety(1);  // the device holds a force for longer
  loop.toFullForce();
  loop.writing = false;
  EXPECT_EQ(loop.ticks(50), 1);
  EXPECT_EQ(loop.tick(), 0);
  EXPECT_EQ(loop.safety.tripped().cause, TripCause::kWriteStuck);
  EXPECT_NEAR(loop.safety.tripped().value, 0.051, 1e-9);
}

TEST(Safety, ALateServoTripsAndCuts) {
  SafetyLoop loop;
  loop.safety = Safety(1);  // the device holds a force for longer
  loop.toFullForce();
  EXPECT_EQ(loop.tick(100), 1);
  EXPECT_EQ(loop.tick(101), 0);
  EXPECT_EQ(loop.safety.tripped().cause, TripCause::kServoLate);
}

TEST(Safety, ASilentProgramMeansZeroAndANewFadeIn) {
  SafetyLoop loop;
  loop.input.heartbeat_ns = loop.now_ns;
  for (int i = 0; i < 1300; ++i) {
    loop.input.armed = i > 2;
    loop.press(i > 10);
    loop.input.heartbeat_ns = loop.now_ns;
    loop.tick();
  }
  ASSERT_EQ(loop.out.force_n, 1);
  EXPECT_EQ(loop.ticks(499), 1);  // the last sign of life was before the last tick
  loop.ticks(31);
  EXPECT_EQ(loop.out.force_n, 0);
  EXPECT_TRUE(loop.limited(kLimitedByGui));
  EXPECT_FALSE(loop.safety.tripped());
  EXPECT_EQ(loop.ticks(5000), 0);
  loop.input.heartbeat_ns = loop.now_ns;
  loop.ticks(200);
  EXPECT_NEAR(loop.out.force_n, 0.2, 1e-9);
}

TEST(Safety, DeviceFaultsTripAtOnce) {
  struct Case {
    DeviceFault fault;
    TripCause cause;
    bool fades;
  };
  const Case cases[] = {{DeviceFault::kLost, TripCause::kDeviceLost, false},
                        {DeviceFault::kNotCalibrated, TripCause::kDeviceFault, false},
                        {DeviceFault::kSwitchedOff, TripCause::kDeviceFault, false},
                        {DeviceFault::kFailed, TripCause::kDeviceFault, false},
                        {DeviceFault::kWarmMotors, TripCause::kDeviceFault, true},
                        {DeviceFault::kForceLimited, TripCause::kDeviceFault, true}};
  for (const Case& c : cases) {
    SafetyLoop loop;
    loop.toFullForce();
    loop.device.fault = c.fault;
    loop.tick();
    EXPECT_EQ(loop.safety.tripped().cause, c.cause);
    const bool named = c.cause == TripCause::kDeviceFault;
    EXPECT_EQ(loop.safety.tripped().value, named ? static_cast<double>(static_cast<int>(c.fault)) : 0);
    EXPECT_NEAR(loop.out.force_n, c.fades ? 29.0 / 30 : 0, 1e-9);
    EXPECT_EQ(loop.ticks(29), 0);
  }
}

TEST(Safety, APositionThatIsNoneTripsAndDoesNotSpoilWhatFollows) {
  for (const double bad_mm : {std::nan(""), std::numeric_limits<double>::infinity(), -1e300}) {
    SafetyLoop loop;
    loop.toFullForce();
    loop.input.position_mm = bad_mm;
    EXPECT_EQ(loop.ticks(5), 0);
    EXPECT_EQ(loop.safety.tripped().cause, TripCause::kPositionNotFinite);
    loop.input.position_mm = 0;
    loop.toFullForce();
    EXPECT_FALSE(loop.safety.tripped());
    EXPECT_EQ(loop.out.force_n, 1);
  }
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

TEST(Trip, IsDescribedForAPerson) {
  EXPECT_EQ(sentence({TripCause::kTooFastOutwards, 431.2, 400, 0}),
            "the hand moved outwards too fast: 431 mm/s, allowed 400 mm/s");
  EXPECT_EQ(sentence({TripCause::kDeviceSilent, 0.1012, 0.1, 0}),
            "the device sent no sample for too long: 0.101 s, allowed 0.100 s");
  EXPECT_EQ(sentence({TripCause::kStopped, 0, 0, 0}), "Stop was pressed");
  EXPECT_EQ(sentence({TripCause::kDeviceFault, 3, 0, 0}),
            "a switch, the device itself or another program holds the forces back");
  EXPECT_EQ(sentence({TripCause::kDeviceFault, 4, 0, 0}), "the motors are too warm");
  EXPECT_EQ(sentence({TripCause::kRenderer, 2, 0, 0}), "the renderer let go: the model's force was not a number");
  for (int i = 0; i <= static_cast<int>(TripCause::kStopped); ++i)
    EXPECT_NE(describe(static_cast<TripCause>(i)), "unknown trip") << i;
}

/// Whatever a trip is about, a number in its sentence has a unit.
TEST(Trip, NoSentenceHasABareNumber) {
  for (int cause = 0; cause <= static_cast<int>(TripCause::kStopped); ++cause) {
    for (int value = 0; value < 9; ++value) {
      const Trip trip{static_cast<TripCause>(cause), static_cast<double>(value), 1, 0};
      const std::string text = sentence(trip);
      EXPECT_FALSE(text.empty());
      EXPECT_EQ(text.find('('), std::string::npos) << text;
      if (unitOf(trip.cause).empty() && text.find("1 km") == std::string::npos) {
        EXPECT_EQ(text.find_first_of("0123456789"), std::string::npos) << text;
      }
    }
  }
}

}  // namespace
}  // namespace tactus::haptics
