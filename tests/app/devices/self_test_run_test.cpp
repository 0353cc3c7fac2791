#include <gtest/gtest.h>

#include "app/devices/guided_runs.h"

#include "tests/app/devices/played_test.h"

namespace tactus::devices {
namespace {

struct Told final : SelfTestGuide {
  void instruct(const std::string& sentence) override { instructions.push_back(sentence); }
  void tell(const CheckResult& result) override { results.push_back(result); }
  Felt ask(const std::string&) override {
    ++questions;
    return Felt::kToward;
  }
  bool interrupted() const noexcept override { return !instructions.empty() && interrupts; }
  bool interrupts = false;  ///< as soon as the person is asked for something
  std::vector<std::string> instructions;
  std::vector<CheckResult> results;
  int questions = 0;
};

TEST(SimulatedSelfTest, RunsByItselfAndPasses) {
  const auto device = haptics::VirtualDevice::make();
  ASSERT_TRUE(device);
  Told guide;
  const auto test = simulateSelfTest(**device, settingsFor((*device)->info()), guide);
  ASSERT_TRUE(test);
  EXPECT_TRUE(test->passed());
  EXPECT_EQ(guide.questions, 0);
  EXPECT_EQ(guide.results.size(), static_cast<std::size_t>(kChecks));
  ASSERT_EQ(guide.instructions.size(), 4u);
  EXPECT_EQ(guide.instructions[0], "Move the handle about 5 cm away from you, then back.");
}

TEST(SelfTestSettingsFor, ShiftsAreLargerThanTheCountsOfTheDevice) {
  haptics::DeviceInfo info;
  info.id = "hid:1209:ffb0";
  info.max_force_n = 1;
  info.count_mm = 0.5;
  const auto settings = settingsFor(info);
  EXPECT_EQ(settings.smallest_shift_mm, 1);
  EXPECT_EQ(settings.limits.force_cap_n, 1);
  EXPECT_EQ(settings.calibration_advice, "calibrate it: tactus devices calibrate hid:1209:ffb0");
}

/// In real time, but it ends as soon as the device says what is wrong.
TEST(SelfTestRun, ADeviceOnAThreadFailsWhereItsFaultIs) {
  const auto made = haptics::VirtualDevice::make();
  Altered device(**made);
  device.on_read = [](haptics::DeviceState& state) { state.fault = haptics::DeviceFault::kNotCalibrated; };
  Told guide;
  const auto test = runSelfTest(device, settingsFor(device.info()), guide);
  ASSERT_TRUE(test);
  EXPECT_FALSE(test->passed());
  ASSERT_EQ(guide.results.size(), 1u);
  EXPECT_EQ(guide.results[0].check, Check::kCalibration);
}

/// A driver that takes the program on and never calls it.
class StandingStill final : public haptics::HapticDevice, haptics::DeviceLoop {
 public:
  const haptics::DeviceInfo& info() const noexcept override { return info_; }
  base::Result<void> start() override { return {}; }
  void stop() noexcept override { stopped = true; }
  haptics::DeviceState read(std::int64_t) noexcept override { return {}; }
  void write(const haptics::Vector3&, std::int64_t) noexcept override {}
  haptics::DeviceLoop* ownLoop() noexcept override { return this; }
  bool stopped = false;

 private:
  base::Result<void> run(haptics::Ticked&) override { return {}; }
  void end() noexcept override {}
  haptics::DeviceInfo info_;
};

TEST(SelfTestRun, ALoopThatNeverTicksIsGivenUp) {
  StandingStill device;
  Told guide;
  const auto test = runSelfTest(device, {}, guide);
  ASSERT_TRUE(test);
  EXPECT_FALSE(test->passed());
  ASSERT_EQ(guide.results.size(), 1u);
  EXPECT_TRUE(guide.results[0].found.starts_with("the servo missed ticks for too long")) << guide.results[0].found;
  EXPECT_TRUE(device.stopped);
}

TEST(SelfTestRun, AnInterruptionStopsTheDevice) {
  const auto made = haptics::VirtualDevice::make();
  Told guide;
  guide.interrupts = true;
  const auto test = runSelfTest(**made, settingsFor((*made)->info()), guide);
  ASSERT_FALSE(test);
  EXPECT_EQ(test.error().message(),
            "virtual: found an interruption, and the device was stopped, wanted a complete self-test");
  EXPECT_EQ((*made)->trueForceN(), 0);
  EXPECT_EQ(guide.questions, 0);
}

TEST(SelfTest, ACanceledTestAsksForNoForceAndDidNotPass) {
  SelfTest test({});
  (void)test.takeOrders();
  test.cancel();
  EXPECT_TRUE(test.finished());
  EXPECT_FALSE(test.passed());
  const auto orders = test.takeOrders();
  ASSERT_TRUE(orders);
  EXPECT_EQ(orders->source, haptics::ForceSource::kOff);
  EXPECT_FALSE(orders->armed);
}

}  // namespace
}  // namespace tactus::devices
