// What becomes of errors that the driver reports while the loop runs.
#include <algorithm>

#include "tests/core/haptics/openhaptics/loaded_stand_in.h"

namespace tactus::haptics {
namespace {

class OpenHapticsFaults : public WithStandIn {
 protected:
  void SetUp() override {
    WithStandIn::SetUp();
    device_ = open();
    ASSERT_TRUE(device_);
    ASSERT_TRUE(device_->start());
    program_ = std::make_unique<Asking>(*device_, Vector3{0, 0, 1});
    ASSERT_TRUE(device_->ownLoop()->run(*program_));
    steps(10);
  }
  void TearDown() override { device_.reset(); }

  std::unique_ptr<OpenHapticsDevice> device_;
  std::unique_ptr<Asking> program_;
};

TEST_F(OpenHapticsFaults, ForceErrorsShowInTheNextTickAndTakeTheForceAwayWithin30Ms) {
  struct Case {
    unsigned code;
    DeviceFault fault;
  };
  for (const Case& one : {Case{0x0200, DeviceFault::kWarmMotors}, Case{0x0201, DeviceFault::kForceLimited},
                          Case{0x0202, DeviceFault::kForceLimited}, Case{0x0203, DeviceFault::kForceLimited},
                          Case{0x0204, DeviceFault::kForceLimited}, Case{0x0300, DeviceFault::kFailed}}) {
    device_.reset();
    SetUp();
    ASSERT_EQ(standIn().force_n[2], 1);
    standIn().errors_of_next_frame = {one.code};
    step();
    // The program asks on; a device that is sound lets it fade, any other gives nothing.
    const bool fades = one.fault != DeviceFault::kFailed;
    for (int i = 1; i <= 100; ++i) {
      step();
      ASSERT_EQ(program_->seen.fault, one.fault) << one.code;
      ASSERT_NEAR(standIn().force_n[2], fades ? std::max(0.0, 1 - i / 30.0) : 0, 1e-9) << one.code;
    }
    EXPECT_EQ(standIn().force_n[2], 0) << one.code;
    EXPECT_TRUE(device_->lastError());
  }
  EXPECT_EQ(*device_->lastError(), "the device reports a fault (0x0300, internal 42, 'words of the driver')");
}

TEST_F(OpenHapticsFaults, AForceThatTheProgramFadesIsGivenAsItIs) {
  standIn().errors_of_next_frame = {0x0200};
  step();
  for (const double asked_n : {0.9, 0.7, 0.3, -0.3}) {
    program_->force_n = {0, 0, asked_n};
    step();
    EXPECT_EQ(standIn().force_n[2], asked_n);
  }
  // Nothing is made larger again.
  program_->force_n = {0, 2, 0};
  step();
  EXPECT_EQ(standIn().force_n[1], 0.3);
  program_->force_n = {};
  step();
  program_->force_n = {0, 0, 0.5};
  step();
  EXPECT_EQ(standIn().force_n[2], 0);
}

TEST_F(OpenHapticsFaults, AGraverErrorEndsTheFadeAndTheSameOneDoesNotProlongIt) {
  for (int i = 1; i <= 10; ++i) {
    standIn().errors_of_next_frame = {0x0200};
    step();
  }
  EXPECT_NEAR(standIn().force_n[2], 1 - 9 / 30.0, 1e-9);
  standIn().errors_of_next_frame = {0x0300};
  step();
  step();
  EXPECT_EQ(standIn().force_n[2], 0);
}

TEST_F(OpenHapticsFaults, AForceThatWasRefusedIsNotCountedAsWritten) {
  const std::int64_t written_ns = now_ns_;
  standIn().errors_of_next_frame = {0x0201};
  step();
  step();
  EXPECT_EQ(program_->seen.written_ns, written_ns);
}

TEST_F(OpenHapticsFaults, TheFaultStaysWhileTheProgramStillAsksForForce) {
  standIn().errors_of_next_frame = {0x0200};
  steps(2000);
  EXPECT_EQ(program_->seen.fault, DeviceFault::kWarmMotors);
  EXPECT_FALSE(standIn().force_output);
}

TEST_F(OpenHapticsFaults, AfterHalfASecondWithoutForceTheActuatorsAreSwitchedOnAgain) {
  standIn().errors_of_next_frame = {0x0202};
  step();
  program_->force_n = {};
  steps(499);
  EXPECT_EQ(program_->seen.fault, DeviceFault::kForceLimited);
  EXPECT_FALSE(standIn().force_output);
  steps(2);
  EXPECT_EQ(program_->seen.fault, DeviceFault::kNone);
  EXPECT_TRUE(standIn().force_output);
  program_->force_n = {0, 0, 0.5};
  step();
  EXPECT_EQ(standIn().force_n[2], 0.5);
}

TEST_F(OpenHapticsFaults, MotorsThatAreStillWarmAreTriedAgainLater) {
  standIn().errors_of_next_frame = {0x0200};
  standIn().enable_again_error = 0x0200;
  program_->force_n = {};
  steps(1200);
  EXPECT_EQ(program_->seen.fault, DeviceFault::kWarmMotors);
  standIn().enable_again_error = 0;
  steps(502);
  EXPECT_EQ(program_->seen.fault, DeviceFault::kNone);
}

TEST_F(OpenHapticsFaults, ALostDeviceTicksOnceMoreAndEndsTheLoop) {
  for (const unsigned code : {0x0302u, 0x0304u, 0x0400u, 0x0401u}) {
    device_.reset();
    SetUp();
    const int before = program_->ticks;
    standIn().errors_of_next_frame = {0x0200, code};
    step();
    EXPECT_EQ(program_->ticks, before + 2) << code;
    EXPECT_EQ(program_->seen.fault, DeviceFault::kLost) << code;
    EXPECT_FALSE(standIn().scheduled) << code;
    EXPECT_FALSE(step()) << code;
    EXPECT_FALSE(device_->ownLoop()->run(*program_)) << code;
    pauses_ = 0;
    standIn().calls.clear();
    device_->stop();
    EXPECT_EQ(pauses_, 0) << code;
    EXPECT_EQ(standIn().calls, (std::vector<std::string>{"stop scheduler", "disable"})) << code;
  }
}

TEST_F(OpenHapticsFaults, ALibraryThatNeverRunsOutOfErrorsDoesNotHoldTheLoop) {
  standIn().error_for_ever = true;
  steps(3);
  EXPECT_EQ(program_->seen.fault, DeviceFault::kFailed);
  EXPECT_EQ(standIn().force_n[2], 0);
  standIn().error_for_ever = false;
}

}  // namespace
}  // namespace tactus::haptics
