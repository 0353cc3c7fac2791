// What the safety layer watches: the speed of the hand, the age of samples and writes, the servo, the program.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/haptics/safety/safety.h"

#include "tests/core/haptics/safety/safety_loop.h"

namespace tactus::haptics {
namespace {

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

}  // namespace
}  // namespace tactus::haptics
