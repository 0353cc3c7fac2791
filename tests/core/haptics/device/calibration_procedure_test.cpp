#include "core/haptics/device/calibration_procedure.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

#include "tests/core/haptics/device/calibration_person.h"

namespace tactus::haptics {
namespace {

using Step = CalibrationStep;

// A rising push of 2 % of full scale per second lasts at most the ticks until 4 counts are seen.
constexpr double kFrictionToleranceN = 0.03;

TEST(CalibrationProcedure, FindsTheNumbersOfADevice) {
  for (const double sign : {1.0, -1.0}) {
    UncalibratedDevice device;
    device.sign = {1, 1, sign};
    CalibrationPerson person(samplePlan(), device);
    person.measureAllButTheScale();
    ASSERT_EQ(person.procedure.step(), Step::kScaleReady) << person.procedure.instruction();
    person.hold(0);
    person.proceed();
    ASSERT_EQ(person.procedure.step(), Step::kScaleLow);
    person.ticks(600);
    person.enter(person.device.springScaleN() - 0.1);
    ASSERT_EQ(person.procedure.step(), Step::kScaleHigh);
    person.ticks(600);
    person.enter(person.device.springScaleN() - 0.1);
    ASSERT_EQ(person.procedure.step(), Step::kDone);
    const auto result = person.procedure.result("2026-11-21T08:00:00Z");
    ASSERT_TRUE(result) << result.error().message();
    EXPECT_NEAR(result->full_scale_n, 8, 1e-9) << "a constant error of the scale cancels";
    EXPECT_NEAR(result->mm_per_count, 0.02, 1e-9);
    EXPECT_EQ(result->force_sign, (Vector3{1, 1, sign}));
    EXPECT_EQ(result->inwards, (Vector3{0, 0, -1}));
    EXPECT_NEAR(result->origin_mm.z, 20, 0.02);
    EXPECT_NEAR(*result->friction_in_n, 0.30, kFrictionToleranceN);
    EXPECT_NEAR(*result->friction_out_n, 0.45, kFrictionToleranceN);
    EXPECT_FALSE(result->silent_when_still);
    EXPECT_EQ(result->procedure, "guided 2, spring scale");
    EXPECT_LE(person.device.largest_share, CalibrationProcedure::kHighShare + 1e-12);
    EXPECT_EQ(person.device.last_share, (Vector3{})) << "no force after the end";
  }
}

TEST(CalibrationProcedure, AKnownWeightServesInPlaceOfASpringScale) {
  CalibrationPerson person(samplePlan(ScaleMethod::kKnownWeight), {});
  person.measureAllButTheScale();
  ASSERT_EQ(person.procedure.step(), Step::kWeight) << person.procedure.instruction();
  person.device.weight_n = 0.981;
  person.ticks(3000);
  person.enter(0.981);
  person.untilNotIn(Step::kLift);
  ASSERT_EQ(person.procedure.step(), Step::kDone) << person.procedure.instruction();
  // The push at the first motion is seen a little late: 0.2 % of full scale twice, of a lift of 12 %.
  EXPECT_NEAR(person.procedure.result("")->full_scale_n, 8, 0.3);
}

TEST(CalibrationProcedure, TheSignOfEveryAxisIsFoundWithASmallShortPush) {
  UncalibratedDevice device;
  device.sign = {-1, 1, -1};
  CalibrationPerson person(samplePlan(ScaleMethod::kSpringScale, true), device);
  person.proceed();
  person.untilNotIn(Step::kRest);
  double pushed_s = 0;
  while (person.procedure.step() == Step::kSign) {
    person.ticks(1);
    pushed_s += person.device.last_share == Vector3{} ? 0 : kCalibrationTickS;
  }
  EXPECT_EQ(person.procedure.step(), Step::kOuterEnd);
  EXPECT_LE(person.device.largest_share, 0.10 + 1e-12) << "5 % does not overcome the friction of 0.45 N of 8 N along z";
  EXPECT_LE(pushed_s, 3 * CalibrationProcedure::kSignS + 2 * kCalibrationTickS);
}

TEST(CalibrationProcedure, NoiseIsNotTakenForMotion) {
  UncalibratedDevice device;
  device.noise_counts = 5;
  device.silent = false;
  CalibrationPerson person(samplePlan(), device);
  person.measureAllButTheScale();
  ASSERT_EQ(person.procedure.step(), Step::kScaleReady);
  person.hold(0);
  person.proceed();
  person.ticks(600);
  person.enter(0.8);
  person.ticks(600);
  person.enter(1.6);
  const auto result = person.procedure.result("");
  ASSERT_TRUE(result);
  // Three times the noise of 5 counts have to be passed: the push is seen later.
  EXPECT_NEAR(*result->friction_in_n, 0.30, 2 * kFrictionToleranceN);
}

TEST(CalibrationProcedure, ADeviceWithoutPowerIsToldApart) {
  UncalibratedDevice device;
  device.no_power = true;
  CalibrationPerson person(samplePlan(), device);
  person.proceed();
  person.untilNotIn(Step::kRest);
  person.untilNotIn(Step::kSign);
  EXPECT_EQ(person.procedure.step(), Step::kFailed);
  EXPECT_EQ(person.procedure.instruction(),
            "The handle did not move along z at 15 % of full scale. Is the motor power on, and is the handle free?");
  EXPECT_FALSE(person.procedure.result(""));
}

TEST(CalibrationProcedure, ASilentDeviceIsNoticed) {
  UncalibratedDevice device;
  device.silent = true;
  CalibrationPerson person(samplePlan(), device);
  person.measureAllButTheScale();
  person.hold(0);
  person.proceed();
  person.ticks(600);
  person.enter(0.8);
  person.ticks(600);
  person.enter(1.6);
  ASSERT_TRUE(person.procedure.result(""));
  EXPECT_TRUE(person.procedure.result("")->silent_when_still);
}

TEST(CalibrationProcedure, AHandleThatMovesAtRestIsAskedForAgain) {
  CalibrationPerson person(samplePlan(), {});
  person.proceed();
  person.ticks(100);
  person.device.position_mm.z += 30;
  person.ticks(2);
  EXPECT_EQ(person.procedure.step(), Step::kLetGo);
  EXPECT_EQ(person.procedure.instruction(), "The handle moved. Let it come to rest, keep clear of it, then continue.");
}

TEST(CalibrationProcedure, AHandleThatSlipsFromTheScaleIsNotPushedOn) {
  CalibrationPerson person(samplePlan(), {});
  person.measureAllButTheScale();
  person.hold(0);
  person.proceed();
  person.ticks(600);
  EXPECT_NE(person.device.last_share, (Vector3{}));
  person.letGo();
  person.device.friction_out_n = 0;
  for (int i = 0; i < 5000 && person.procedure.step() == Step::kScaleLow; ++i) person.ticks(1);
  EXPECT_EQ(person.procedure.step(), Step::kScaleReady);
  person.ticks(1);
  EXPECT_EQ(person.device.last_share, (Vector3{}));
}

TEST(CalibrationProcedure, ReadingsThatCannotBeAreRefused) {
  CalibrationPerson person(samplePlan(), {});
  EXPECT_FALSE(person.procedure.enter(3)) << "nothing was asked";
  person.measureAllButTheScale();
  person.hold(0);
  person.proceed();
  EXPECT_EQ(person.procedure.enter(0.8).error().message(),
            "measurement: found a reading while the push still rises, wanted one after it has settled");
  person.ticks(600);
  EXPECT_FALSE(person.procedure.enter(-1));
  EXPECT_FALSE(person.procedure.enter(std::nan("")));
  person.enter(0.8);
  person.ticks(600);
  EXPECT_EQ(person.procedure.enter(0.7).error().message(),
            "measurement: found 0.8 N and then 0.7 N, wanted about twice as much at the second push");
  person.enter(1.6);
  EXPECT_EQ(person.procedure.step(), Step::kDone);
}

TEST(CalibrationProcedure, AFaultOrTheEndOfPatienceStopsTheForce) {
  CalibrationPerson person(samplePlan(), {});
  person.measureAllButTheScale();
  person.hold(0);
  person.proceed();
  person.ticks(600);
  ASSERT_NE(person.device.last_share, (Vector3{}));
  CalibrationPerson other = person;
  person.procedure.cancel();
  EXPECT_EQ(person.procedure.tick(person.device.state(), person.device.now_ns + 1), (Vector3{}));
  EXPECT_EQ(person.procedure.step(), Step::kFailed);
  auto lost = other.device.state();
  lost.fault = DeviceFault::kLost;
  EXPECT_EQ(other.procedure.tick(lost, other.device.now_ns + 1), (Vector3{}));
  EXPECT_EQ(other.procedure.step(), Step::kFailed);
  EXPECT_EQ(other.procedure.tick(other.device.state(), other.device.now_ns + 2), (Vector3{}));
}

/// A path in the plane of x and z on a device with one motor, along z.
class PathBesideTheMotor : public testing::Test {
 protected:
  /// To the end of the way inwards, 60 mm, `angle_deg` off the motor.
  void moveAlong(double angle_deg) {
    angle_ = angle_deg * std::numbers::pi / 180;
    person_.proceed();
    person_.untilNotIn(Step::kRest);
    person_.untilNotIn(Step::kSign);
    ASSERT_EQ(person_.procedure.step(), Step::kOuterEnd);
    at(0);
    person_.proceed();
    at(60);
    person_.proceed();
  }
  void at(double depth_mm) {
    person_.device.position_mm.x = depth_mm * std::sin(angle_);
    person_.hold(20 - depth_mm * std::cos(angle_));
  }

  CalibrationPerson person_{samplePlan(), {}};
  double angle_ = 0;
};

TEST_F(PathBesideTheMotor, FullScaleIsThatOfTheMotorAndFrictionThatAlongThePath) {
  moveAlong(20);
  ASSERT_EQ(person_.procedure.step(), Step::kRuler) << person_.procedure.instruction();
  person_.enter(60);
  person_.hold(0);
  person_.letGo();
  person_.proceed();
  person_.untilNotIn(Step::kFrictionIn);
  person_.untilNotIn(Step::kFrictionOut);
  EXPECT_EQ(person_.procedure.instruction(),
            "Hold the handle back with a spring scale that pulls inwards, straight along z (toward you and away), 20 "
            "degrees beside the way of the tube, so that it cannot move outwards. Then continue.");
  person_.hold(0);
  person_.proceed();
  person_.ticks(600);
  person_.enter(person_.device.springScaleN());
  person_.ticks(600);
  person_.enter(person_.device.springScaleN());
  const auto result = person_.procedure.result("");
  ASSERT_TRUE(result) << result.error().message();
  EXPECT_NEAR(result->full_scale_n, 8, 1e-9);
  // Places are known to a count of 3000, so the direction to 0.03 %.
  EXPECT_NEAR(result->inwards.x, std::sin(angle_), 5e-4);
  EXPECT_NEAR(result->inwards.z, -std::cos(angle_), 5e-4);
  EXPECT_NEAR(*result->friction_in_n, 0.30 * std::cos(angle_), kFrictionToleranceN);
  EXPECT_NEAR(*result->friction_out_n, 0.45 * std::cos(angle_), kFrictionToleranceN);
}

TEST_F(PathBesideTheMotor, OneThatIsTooFarOffIsRefused) {
  moveAlong(25);
  EXPECT_EQ(person_.procedure.step(), Step::kRuler) << "cos 25 degrees is 0.906";
  CalibrationPerson other(samplePlan(), {});
  person_ = other;
  moveAlong(27);
  EXPECT_EQ(person_.procedure.step(), Step::kFailed) << "cos 27 degrees is 0.891";
  EXPECT_EQ(person_.procedure.instruction(),
            "This way is 27 degrees off the motors, which push along z (toward you and away); 26 degrees are the most. "
            "Begin anew with a way along them.");
}

TEST(CalibrationProcedure, AnAxisWithoutAMotorIsRefused) {
  CalibrationPlan along_x = samplePlan();
  along_x.driven = {true, false, false};
  CalibrationPerson person(along_x, {});
  person.proceed();
  person.untilNotIn(Step::kRest);
  person.untilNotIn(Step::kSign);
  person.hold(20);
  person.proceed();
  person.hold(-40);
  person.proceed();
  EXPECT_EQ(person.procedure.step(), Step::kFailed);
  EXPECT_TRUE(person.procedure.instruction().starts_with("This way is 90 degrees off the motors"))
      << person.procedure.instruction();
}

TEST(CalibrationPlanFor, DrivesTheAxesThatHaveMotors) {
  DeviceInfo info;
  info.id = "hid:1209:ffb0:7";
  info.serial = "7";
  info.force_axes = 1;
  EXPECT_EQ(planFor(info).driven, (DrivenAxes{true, false, false}));
  // HID's second axis, Y, points to the person (HID 1.11, 5.9), which is z here.
  info.force_axes = 2;
  EXPECT_EQ(planFor(info).driven, (DrivenAxes{true, false, true}));
  EXPECT_EQ(planFor(info).device, "hid:1209:ffb0:7");
  EXPECT_EQ(planFor(info).serial, "7");
}

/// Of each push: positions stop, or forces do not arrive, in the middle of it.
TEST(CalibrationProcedure, OldPositionsAndForcesThatDoNotArriveAreNoMeasurement) {
  for (const bool mute : {true, false}) {
    for (const int after_ms : {0, 100, 5000}) {
      SCOPED_TRACE(mute ? "mute" : "stuck");
      UncalibratedDevice device;
      device.friction_in_n = 1.9;  // the push rises for long
      CalibrationPerson person(samplePlan(), device);
      person.proceed();
      person.untilNotIn(Step::kRest);
      person.untilNotIn(Step::kSign);
      ASSERT_EQ(person.procedure.step(), Step::kOuterEnd);
      const std::int64_t from_ns = person.device.now_ns + after_ms * std::int64_t{1'000'000};
      (mute ? person.device.mute_from_ns : person.device.stuck_from_ns) = from_ns;
      person.untilNotIn(Step::kOuterEnd);
      EXPECT_EQ(person.procedure.step(), Step::kFailed);
      EXPECT_EQ(person.procedure.instruction(),
                std::string(mute ? "The device has sent no position" : "No force has reached the device") +
                    " for 0.2 s. Check its cable, close other programs that use it, then begin anew.");
      EXPECT_NEAR(static_cast<double>(person.device.now_ns - from_ns) * 1e-6, 201, 3);
      EXPECT_EQ(person.device.last_share, Vector3{});
    }
  }
}

TEST(CalibrationProcedure, SilenceOfADeviceThatIsSilentWhenStillIsNoFault) {
  UncalibratedDevice device;
  device.silent = true;
  CalibrationPerson person(samplePlan(), device);
  person.proceed();
  person.untilNotIn(Step::kRest);
  person.untilNotIn(Step::kSign);
  ASSERT_EQ(person.procedure.step(), Step::kOuterEnd);
  person.device.mute_from_ns = person.device.now_ns;
  person.ticks(3000);
  EXPECT_EQ(person.procedure.step(), Step::kOuterEnd);
}

}  // namespace
}  // namespace tactus::haptics
