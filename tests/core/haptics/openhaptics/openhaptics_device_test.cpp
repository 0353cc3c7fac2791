#include <cmath>
#include <limits>

#include "core/haptics/servo/servo.h"

#include "tests/core/haptics/openhaptics/loaded_stand_in.h"

namespace tactus::haptics {
namespace {

using OpenHaptics = WithStandIn;
using Calls = std::vector<std::string>;

TEST_F(OpenHaptics, StartsInTheOrderThatTheDriverNeeds) {
  const auto device = open();
  standIn().calls.clear();
  ASSERT_TRUE(device->start());
  EXPECT_EQ(standIn().calls, (Calls{"enable", "enable", "enable", "schedule 65535", "start scheduler"}));
  EXPECT_EQ(standIn().rate_hz, 1000u);
  EXPECT_TRUE(standIn().force_output);
  EXPECT_TRUE(device->start());  // again: nothing more
  EXPECT_EQ(standIn().calls.size(), 5u);
}

TEST_F(OpenHaptics, WithoutAProgramThereIsNoForce) {
  const auto device = open();
  ASSERT_TRUE(device->start());
  device->write({1, 2, 0}, 0);
  steps(5);
  EXPECT_EQ(standIn().largest_force_n, 0);
}

TEST_F(OpenHaptics, TheProgramTicksBetweenFreshSampleAndWrite) {
  const auto device = open();
  ASSERT_TRUE(device->start());
  Asking program(*device, {0.1, -0.2, 0.3});
  ASSERT_NE(device->ownLoop(), nullptr);
  ASSERT_TRUE(device->ownLoop()->run(program));
  standIn().position_mm[0] = 1.5;
  standIn().position_mm[1] = -20;
  standIn().position_mm[2] = 3;
  standIn().velocity_mm_s[2] = -80;
  standIn().buttons = 2;
  step();
  EXPECT_EQ(program.ticks, 1);
  EXPECT_EQ(program.time_ns, now_ns_);
  EXPECT_EQ(program.seen.number, 1u);
  EXPECT_EQ(program.seen.time_ns, now_ns_);
  EXPECT_EQ(program.seen.position_mm, (Vector3{1.5, -20, 3}));
  ASSERT_TRUE(program.seen.velocity_mm_s);
  EXPECT_EQ(*program.seen.velocity_mm_s, (Vector3{0, 0, -80}));
  EXPECT_EQ(program.seen.buttons, 2u);
  EXPECT_EQ(program.seen.fault, DeviceFault::kNone);
  EXPECT_EQ(program.seen.written_ns, 0);
  // In the same frame, in newtons.
  EXPECT_EQ(standIn().force_n[0], 0.1);
  EXPECT_EQ(standIn().force_n[1], -0.2);
  EXPECT_EQ(standIn().force_n[2], 0.3);
  const std::int64_t first_ns = now_ns_;
  step();
  EXPECT_EQ(program.seen.number, 2u);
  EXPECT_EQ(program.seen.written_ns, first_ns);
  EXPECT_FALSE(device->lastError());
}

TEST_F(OpenHaptics, AVelocityThatIsNoneIsLeftOut) {
  const auto device = open();
  ASSERT_TRUE(device->start());
  Asking program(*device);
  ASSERT_TRUE(device->ownLoop()->run(program));
  standIn().velocity_mm_s[1] = std::nan("");
  step();
  EXPECT_FALSE(program.seen.velocity_mm_s);
}

TEST_F(OpenHaptics, AForceIsFiniteAndAtMostTheDevicesLargest) {
  const auto device = open();
  ASSERT_TRUE(device->start());
  Asking program(*device, {6, 0, 8});
  ASSERT_TRUE(device->ownLoop()->run(program));
  step();
  // 3.3 N along (0.6, 0, 0.8); a few roundings.
  EXPECT_NEAR(standIn().force_n[0], 1.98, 1e-14);
  EXPECT_NEAR(standIn().force_n[2], 2.64, 1e-14);
  program.force_n = {0, std::numeric_limits<double>::infinity(), 0};
  step();
  EXPECT_EQ(standIn().force_n[1], 0);
  program.force_n = {1e308, 1e308, 1e308};  // its length overflows
  step();
  EXPECT_LE(std::hypot(standIn().force_n[0], standIn().force_n[1], standIn().force_n[2]), 3.3 * (1 + 1e-15));
  EXPECT_TRUE(standIn().force_output);
}

TEST_F(OpenHaptics, AfterEndTheProgramIsNotCalledAndThereIsNoForce) {
  const auto device = open();
  ASSERT_TRUE(device->start());
  Asking program(*device, {0, 0, 1});
  ASSERT_TRUE(device->ownLoop()->run(program));
  steps(3);
  device->ownLoop()->end();
  steps(3);
  EXPECT_EQ(program.ticks, 3);
  EXPECT_EQ(standIn().force_n[2], 0);
  Asking next(*device);  // the force of the program before is gone
  ASSERT_TRUE(device->ownLoop()->run(next));
  step();
  EXPECT_EQ(next.ticks, 1);
}

TEST_F(OpenHaptics, StoppingPutsThirtyMillisecondsOfNoForceBeforeTheEnd) {
  const auto device = open();
  ASSERT_TRUE(device->start());
  Asking program(*device, {0, 0, 1});
  ASSERT_TRUE(device->ownLoop()->run(program));
  steps(10);
  EXPECT_EQ(standIn().force_n[2], 1);
  standIn().calls.clear();
  device->stop();
  EXPECT_EQ(program.ticks, 10);
  EXPECT_EQ(pauses_, 30);
  EXPECT_EQ(standIn().frames, 40);
  EXPECT_EQ(standIn().force_n[2], 0);
  EXPECT_EQ(standIn().calls, (Calls{"stop scheduler", "unschedule", "disable"}));
  EXPECT_FALSE(standIn().force_output);
  device->stop();  // again: nothing more
  EXPECT_EQ(standIn().calls.size(), 3u);
}

TEST_F(OpenHaptics, ADriverThatStandsStillIsNotWaitedForLong) {
  OpenHapticsSettings still = settings();
  still.pause = [this] { ++pauses_; };
  const auto device = open(std::move(still));
  ASSERT_TRUE(device->start());
  device->stop();
  EXPECT_EQ(pauses_, 100);
  EXPECT_FALSE(standIn().running);
}

TEST_F(OpenHaptics, TheDestructorStopsAndGivesTheDeviceBack) {
  auto device = open();
  ASSERT_TRUE(device->start());
  standIn().calls.clear();
  device.reset();
  EXPECT_EQ(standIn().calls, (Calls{"stop scheduler", "unschedule", "disable", "disable device"}));
  EXPECT_EQ(standIn().open_devices, 0);
  EXPECT_TRUE(open());
}

TEST_F(OpenHaptics, CanBeStartedAgain) {
  const auto device = open();
  ASSERT_TRUE(device->start());
  device->stop();
  EXPECT_EQ(device->ownLoop()->run(*std::make_unique<Asking>(*device)).error().message(),
            "openhaptics: found a loop that does not run, wanted a started device");
  ASSERT_TRUE(device->start());
  Asking program(*device, {0, 0, 1});
  ASSERT_TRUE(device->ownLoop()->run(program));
  step();
  EXPECT_EQ(program.seen.number, 1u);
  EXPECT_EQ(standIn().force_n[2], 1);
}

TEST_F(OpenHaptics, AStartThatFailsLeavesNothingRunning) {
  struct Case {
    unsigned stand_in::State::*error;
    unsigned code;
    const char* found;
  };
  for (const Case& one : {Case{&stand_in::State::refused_capability, 0x4000, "could not give the force (0x0204"},
                          Case{&stand_in::State::schedule_error, 0x0501, "takes no further callback (0x0501"},
                          Case{&stand_in::State::rate_error, 0x0101, "the driver reports an error (0x0101"},
                          Case{&stand_in::State::start_error, 0x0304, "the driver's timer failed (0x0304"}}) {
    SetUp();
    standIn().*one.error = one.code;
    const auto device = open();
    const auto started = device->start();
    ASSERT_FALSE(started) << one.found;
    EXPECT_NE(started.error().message().find(one.found), std::string::npos) << started.error().message();
    EXPECT_FALSE(standIn().scheduled);
    EXPECT_FALSE(standIn().running);
    EXPECT_FALSE(standIn().force_output);
    standIn().*one.error = 0;
    EXPECT_TRUE(device->start());
  }
}

TEST_F(OpenHaptics, AnUncalibratedDeviceStartsWithoutForceUntilAPersonHasCalibratedIt) {
  standIn().calibration = hd::kNeedsManualInput;
  const auto device = open();
  ASSERT_TRUE(device->start());
  EXPECT_FALSE(device->calibrated());
  EXPECT_EQ(device->calibrationAdvice(), "put the stylus into the inkwell and leave it there for a second");
  Asking program(*device, {0, 0, 1});
  ASSERT_TRUE(device->ownLoop()->run(program));
  steps(150);
  EXPECT_EQ(program.seen.fault, DeviceFault::kNotCalibrated);
  EXPECT_EQ(standIn().largest_force_n, 0);
  standIn().calibration = hd::kNeedsUpdate;  // the stylus is in the inkwell
  steps(101);                                // it looks every 100 frames
  EXPECT_TRUE(device->calibrated());
  EXPECT_EQ(program.seen.fault, DeviceFault::kNone);
  EXPECT_EQ(standIn().force_n[2], 1);
}

TEST_F(OpenHaptics, AnEncoderResetIsDoneInTheFrameAfterItWasAskedFor) {
  standIn().calibration = hd::kNeedsUpdate;
  standIn().calibration_styles = hd::kEncoderReset;
  const auto device = open();
  ASSERT_TRUE(device->start());
  steps(3);
  EXPECT_FALSE(device->calibrated());
  device->requestCalibration();
  step();
  EXPECT_TRUE(device->calibrated());
}

TEST_F(OpenHaptics, ARequestFromBeforeTheStartCalibratesNothing) {
  standIn().calibration = hd::kNeedsUpdate;
  standIn().calibration_styles = hd::kEncoderReset;
  const auto device = open();
  device->requestCalibration();  // the hand that held it in its reference posture may have let go
  ASSERT_TRUE(device->start());
  steps(3);
  EXPECT_FALSE(device->calibrated());
  EXPECT_TRUE(standIn().calibration_updates.empty());
}

/// A scheduler that stands still for 70 ms: what the driver does with the last force meanwhile is not known.
TEST_F(OpenHaptics, AStallOfTheDriverEndsInAFadeIn) {
  const auto device = open();
  ASSERT_TRUE(device->start());
  Servo servo(*device);
  ServoOrders orders;
  orders.source = ForceSource::kStimulus;
  orders.armed = true;
  orders.stimulus = {1, 0.8, 0.15, {}, {}};
  servo.post(orders);
  ASSERT_TRUE(device->ownLoop()->run(servo));
  steps(20);
  standIn().buttons = 1;
  steps(1300);
  EXPECT_DOUBLE_EQ(standIn().force_n[2], 0.8);
  now_ns_ += 69'000'000;
  steps(3);
  // By hand: 0.8 N come back within 1 s, 2 ms of it in the first step.
  EXPECT_LE(standIn().force_n[2], 0.8 * 0.004 + 1e-12);
  EXPECT_EQ(servo.statistics().restarts, 1u);
  steps(1000);
  EXPECT_DOUBLE_EQ(standIn().force_n[2], 0.8);
  device->ownLoop()->end();
}

}  // namespace
}  // namespace tactus::haptics
