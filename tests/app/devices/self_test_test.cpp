#include <gtest/gtest.h>
#include <limits>

#include "app/devices/guided_runs.h"

#include "tests/app/devices/played_test.h"

namespace tactus::devices {
namespace {

using haptics::DeviceFault;
using haptics::DeviceState;
using haptics::FaultEvent;
using haptics::InjectedFault;
using haptics::VirtualDevice;
using Phase = SelfTest::Phase;

/// The only check that failed, which is the last one.
CheckResult failure(const SelfTest& test) {
  EXPECT_TRUE(test.finished());
  EXPECT_FALSE(test.passed());
  if (test.results().empty()) {
    ADD_FAILURE() << "no result in phase " << static_cast<int>(test.phase());
    return {};
  }
  for (std::size_t i = 0; i + 1 < test.results().size(); ++i) EXPECT_TRUE(test.results()[i].passed);
  EXPECT_FALSE(test.results().back().passed);
  EXPECT_FALSE(test.results().back().advice.empty());
  return test.results().back();
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(SelfTest, AGoodDevicePassesEveryCheckInOrder) {
  const SelfTest test = Played().run();
  EXPECT_TRUE(test.passed());
  ASSERT_EQ(test.results().size(), static_cast<std::size_t>(kChecks));
  for (int i = 0; i < kChecks; ++i) {
    const auto& result = test.results()[static_cast<std::size_t>(i)];
    EXPECT_EQ(static_cast<int>(result.check), i);
    EXPECT_TRUE(result.passed) << describe(result.check) << ": " << result.found;
    EXPECT_TRUE(result.advice.empty());
  }
  EXPECT_LT(test.shiftMm(), -SelfTestSettings{}.smallest_shift_mm);
}

TEST(SelfTest, ItsPhasesHaveNamesForScreensInOtherLanguages) {
  EXPECT_EQ(SelfTest::name(Phase::kSamples), "samples");
  EXPECT_EQ(SelfTest::name(Phase::kForceOff), "force_off");
  EXPECT_EQ(SelfTest::name(Phase::kDone), "done");
}

TEST(SelfTest, TheShiftIsThatOfTheForceOnTheSpringOfTheHand) {
  Played played;
  played.device.mechanics.dry_friction_n = 0;
  // 0.1 N on the pinch of 100 N/m; half a count of 0.055 mm at both ends.
  EXPECT_NEAR(played.run().shiftMm(), -1, 0.06);
}

TEST(SelfTest, NothingIsAskedForBeforeTheSamplesAreGood) {
  SelfTest test{SelfTestSettings{}};
  EXPECT_EQ(test.instruction(), "");
  const auto orders = test.takeOrders();
  ASSERT_TRUE(orders);
  EXPECT_EQ(orders->source, haptics::ForceSource::kFree);
  EXPECT_TRUE(orders->armed);
  EXPECT_FALSE(test.takeOrders());
}

TEST(SelfTest, AnUncalibratedDeviceIsToldHowToBecomeOne) {
  Played played;
  played.settings.calibration_advice = "calibrate it";
  played.on_read = [](DeviceState& state) { state.fault = DeviceFault::kNotCalibrated; };
  const auto failed = failure(played.run());
  EXPECT_EQ(failed.check, Check::kCalibration);
  EXPECT_EQ(failed.found, "the device is not calibrated");
  EXPECT_EQ(failed.advice, "calibrate it");
}

TEST(SelfTest, FaultsOfTheDeviceEndTheTestInTheirOwnWords) {
  struct Case {
    DeviceFault fault;
    const char* found;
  };
  for (const Case& one :
       {Case{DeviceFault::kWarmMotors, "the motors are too warm"},
        Case{DeviceFault::kSwitchedOff, "a switch, the device itself or another program holds the forces back"},
        Case{DeviceFault::kForceLimited, "the device refused a force"},
        Case{DeviceFault::kFailed, "the device reports a fault"}}) {
    Played played;
    played.on_read = [&](DeviceState& state) { state.fault = one.fault; };
    const auto failed = failure(played.run());
    EXPECT_EQ(failed.check, Check::kSamples);
    EXPECT_EQ(failed.found, one.found);
  }
}

TEST(SelfTest, ASilentDeviceIsNoticedBeforeAnybodyMovesIt) {
  Played played;
  played.device.faults = {FaultEvent{InjectedFault::kStalled, 0.05}};
  const auto failed = failure(played.run());
  EXPECT_EQ(failed.check, Check::kSamples);
  EXPECT_TRUE(contains(failed.found, "no force reached the device for too long")) << failed.found;
}

TEST(SelfTest, ADeviceThatIsUnpluggedInTheMiddleEndsTheTest) {
  Played played;
  played.device.faults = {FaultEvent{InjectedFault::kUnplugged, 2.0}};
  const auto failed = failure(played.run());
  EXPECT_EQ(failed.check, Check::kButton);
  EXPECT_EQ(failed.found, "the device is gone");
}

TEST(SelfTest, APositionThatNoHandReachesIsNone) {
  Played played;
  played.on_read = [](DeviceState& state) { state.position_mm.z -= 4000; };
  const auto failed = failure(played.run());
  EXPECT_EQ(failed.check, Check::kSamples);
  EXPECT_EQ(failed.found.substr(failed.found.find("position")), "position 4000.00 mm");
}

TEST(SelfTest, AStuckPositionRunsOutOfPatience) {
  Played played;
  played.device.faults = {FaultEvent{InjectedFault::kStuckValue, 0}};
  played.settings.patience_s = 3;
  const auto failed = failure(played.run());
  EXPECT_EQ(failed.check, Check::kMotion);
  EXPECT_EQ(failed.found, "moved by 0.00 mm inwards and 0.00 mm outwards within 3 s");
}

TEST(SelfTest, AnAxisThatPointsOutwardsIsFound) {
  Played played;
  played.settings.axis = *haptics::AxisMapping::make({0, 0, 1});
  auto failed = failure(played.run());
  EXPECT_EQ(failed.check, Check::kMotion);
  EXPECT_TRUE(contains(failed.found, "mm outwards first")) << failed.found;
  EXPECT_EQ(failed.advice, "move it away from you first");
  played.settings.axis_advice = "calibrate it again: tactus devices calibrate hid:1209:ffb0";
  failed = failure(played.run());
  EXPECT_EQ(failed.advice,
            "move it away from you first; if you did, calibrate it again: tactus devices calibrate hid:1209:ffb0");
}

TEST(SelfTest, WithoutAButtonOrWithOneThatSticksItEnds) {
  Played played;
  played.settings.patience_s = 3;
  played.on_read = [](DeviceState& state) { state.buttons = 0; };
  EXPECT_EQ(failure(played.run()).found, "no press and release within 3 s");
  played.on_read = [](DeviceState& state) { state.buttons = 4; };
  const auto failed = failure(played.run());
  EXPECT_EQ(failed.check, Check::kButton);
  EXPECT_EQ(failed.found, "a button that stays down within 3 s");
}

TEST(SelfTest, AnyButtonWillDo) {
  Played played;
  played.on_read = [](DeviceState& state) { state.buttons <<= 2; };
  const SelfTest test = played.run();
  EXPECT_TRUE(test.passed());
  EXPECT_EQ(test.results()[static_cast<std::size_t>(Check::kButton)].found, "button 3 went down and up");
}

TEST(SelfTest, ADeviceThatPullsByItselfIsFound) {
  Played played;
  played.person = [](VirtualDevice& device, Phase phase, int tick) {
    Played::dutiful(device, phase, tick);
    // 10 mm/s while it is held: the hand is carried along.
    if (phase == Phase::kForceOff) device.setTarget(-0.01 * tick);
  };
  const auto failed = failure(played.run());
  EXPECT_EQ(failed.check, Check::kForceOff);
  EXPECT_TRUE(contains(failed.found, "held without force it moved by ")) << failed.found;
}

TEST(SelfTest, AButtonThatIsLetGoBeginsTheMeasurementAnew) {
  Played played;
  played.person = [](VirtualDevice& device, Phase phase, int tick) {
    Played::dutiful(device, phase, tick);
    if (phase == Phase::kForceOff && tick > 900 && tick < 1000) device.setButton(false);
    if (phase == Phase::kPulse && tick > 300 && tick < 400) device.setButton(false);  // in the first pull
  };
  EXPECT_TRUE(played.run().passed());
}

TEST(SelfTest, WhoLetsGoInEachPullIsToldSo) {
  Played played;
  played.person = [](VirtualDevice& device, Phase phase, int tick) {
    Played::dutiful(device, phase, tick);
    if (phase == Phase::kPulse) device.setButton(tick % 400 > 50);
  };
  const auto failed = failure(played.run());
  EXPECT_EQ(failed.check, Check::kPulse);
  EXPECT_EQ(failed.found, "the button was let go in 3 pulls");
}

TEST(SelfTest, AForceThatPushesTheWrongWayIsFoundByWhoFeelsIt) {
  Played played;
  played.force_factor = -1;
  played.felt = Felt::kAway;
  const auto failed = failure(played.run());
  EXPECT_EQ(failed.check, Check::kDirection);
  EXPECT_TRUE(contains(failed.found, "a push away from the person, the hand moved by ")) << failed.found;
  EXPECT_TRUE(contains(failed.found, " inwards")) << failed.found;
  EXPECT_TRUE(contains(failed.advice, "do not use it")) << failed.advice;
}

TEST(SelfTest, AFeelingAgainstTheMotionOfTheHandDoesNotPass) {
  Played played;
  played.force_factor = -1;
  played.felt = Felt::kToward;
  EXPECT_TRUE(contains(failure(played.run()).found, "a pull toward the person was felt, but the hand moved"));
}

TEST(SelfTest, AForceThatNobodyFeelsIsNone) {
  Played played;
  played.force_factor = 0;
  played.felt = Felt::kNothing;
  const auto failed = failure(played.run());
  EXPECT_EQ(failed.check, Check::kDirection);
  EXPECT_TRUE(contains(failed.found, "nothing was felt")) << failed.found;
}

TEST(SelfTest, ACapBelowThePulseIsFound) {
  Played played;
  played.settings.limits.force_cap_n = 0.05;
  const auto failed = failure(played.run());
  EXPECT_EQ(failed.check, Check::kPulse);
  EXPECT_EQ(failed.found, "the limits let through only 0.050 N of 0.1 N");
}

TEST(SelfTest, TheForceIsNeverLargerThanThePulseAndOffAtTheEnd) {
  double largest_n = 0;
  Played played;
  const auto made = haptics::VirtualDevice::make(played.device);
  (void)(*made)->start();
  haptics::Servo servo(**made);
  SelfTest test(played.settings);
  Phase phase = test.phase();
  int tick = 0;
  std::int64_t now_ns = 0;
  double last_n = 0;
  for (int after_end = 0; after_end < 100 && now_ns < 60'000'000'000; after_end += test.finished() ? 1 : 0) {
    if (auto orders = test.takeOrders()) test.posted(servo.post(std::move(*orders)));
    servo.tick(now_ns += 1'000'000);
    haptics::Sample room[2];
    for (const auto& sample : servo.drain(room)) {
      largest_n = std::max(largest_n, std::abs(sample.force_n));
      last_n = sample.force_n;
      test.feed(sample);
    }
    if (test.phase() == Phase::kAsk) test.answer(Felt::kToward);
    tick = test.phase() == phase ? tick + 1 : 1;
    phase = test.phase();
    Played::dutiful(**made, phase, tick);
  }
  EXPECT_TRUE(test.passed());
  EXPECT_NEAR(largest_n, 0.1, 1e-12);  // sums of the ramp
  EXPECT_EQ(last_n, 0);
}

}  // namespace
}  // namespace tactus::devices
