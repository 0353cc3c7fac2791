// The self-test on the servo in the loop of a driver: a stand-in for libHD, stepped in virtual time.
#include "app/devices/guided_runs.h"
#include "core/haptics/servo/servo.h"

#include "tests/core/haptics/openhaptics/loaded_stand_in.h"

namespace tactus::devices {
namespace {

using haptics::OpenHapticsDevice;
using haptics::Vector3;
using Phase = SelfTest::Phase;

/// A hand like a spring of 100 N/m around where it wants to be; inwards is -z.
class HandOnStandIn : public haptics::WithStandIn {
 protected:
  SelfTest play(double sign_of_force = 1) {
    const auto device = open();
    EXPECT_TRUE(device->start());
    haptics::Servo servo(*device);
    EXPECT_TRUE(device->ownLoop()->run(servo));
    auto settings = settingsFor(device->info());
    settings.calibration_advice = device->calibrationAdvice();
    SelfTest test(settings);
    Phase phase = test.phase();
    int tick = 0;
    while (!test.finished() && tick < 100000) {
      if (auto orders = test.takeOrders()) test.posted(servo.post(std::move(*orders)));
      step();
      haptics::Sample room[2];
      for (const auto& sample : servo.drain(room)) test.feed(sample);
      if (const auto record = servo.takeFlightRecord()) test.tripped(record->trip);
      if (test.phase() == Phase::kAsk) test.answer(test.shiftMm() < 0 ? Felt::kToward : Felt::kAway);
      tick = test.phase() == phase ? tick + 1 : 1;
      phase = test.phase();
      hold(phase, tick, sign_of_force);
    }
    device->ownLoop()->end();
    return test;
  }

  void hold(Phase phase, int tick, double sign_of_force) {
    // 50 mm inwards and back, 100 mm/s.
    const double wish_mm = phase == Phase::kMotion ? std::min(0.1 * tick, std::max(0.0, 100 - 0.1 * tick)) : 0;
    const double force_n = sign_of_force * standIn().force_n[2];
    standIn().position_mm[2] = -wish_mm + force_n / 0.1;
    const bool button = (phase == Phase::kButton && tick > 100 && tick < 200) ||
                        (phase == Phase::kForceOff && tick > 100) || phase == Phase::kPulse;
    standIn().buttons = button ? 1 : 0;
  }
};

TEST_F(HandOnStandIn, AGoodDevicePasses) {
  const SelfTest test = play();
  EXPECT_TRUE(test.passed()) << (test.results().empty() ? "" : test.results().back().found);
  EXPECT_NEAR(test.shiftMm(), -1, 1e-6);  // 0.1 N on 100 N/m
  EXPECT_NEAR(standIn().largest_force_n, 0.1, 1e-12);
  EXPECT_EQ(standIn().force_n[2], 0);
}

TEST_F(HandOnStandIn, MotorsThatAreTheWrongWayRoundAreFound) {
  const SelfTest test = play(-1);
  EXPECT_FALSE(test.passed());
  ASSERT_FALSE(test.results().empty());
  EXPECT_EQ(test.results().back().check, Check::kDirection);
}

TEST_F(HandOnStandIn, AnUncalibratedDeviceGetsTheAdviceOfItsDriver) {
  standIn().calibration = 0x5002;
  const SelfTest test = play();
  ASSERT_EQ(test.results().size(), 1u);
  EXPECT_EQ(test.results()[0].check, Check::kCalibration);
  EXPECT_EQ(test.results()[0].advice, "put the stylus into the inkwell and leave it there for a second");
}

TEST_F(HandOnStandIn, AServoThreadLeavesTheDriversLoopBeforeTheDeviceStops) {
  const auto device = open();
  ASSERT_TRUE(device->start());
  haptics::Servo servo(*device);
  haptics::ServoThread thread(servo);
  ASSERT_TRUE(thread.start());
  EXPECT_TRUE(thread.state().own_loop);
  steps(20);
  EXPECT_EQ(servo.ticks(), 20u);
  thread.stop();
  steps(20);
  EXPECT_EQ(servo.ticks(), 20u);
}

}  // namespace
}  // namespace tactus::devices
