#include <gtest/gtest.h>

#include "core/haptics/hid/hid_pid_device.h"

#include "tests/core/haptics/loop_numbers.h"
#include "tests/support/fake_pid_device.h"

namespace tactus::haptics {
namespace {

using support::FakePidDevice;
using support::PidModel;

PidLayout foundLayout(PidModel model) {
  return *PidLayout::find(*ReportDescriptor::parse(support::reportDescriptor(model)));
}

TEST(PidInput, ReadsPositionAndButtonsOfEveryModel) {
  for (const PidModel model : support::kPidModels) {
    const FakePidDevice device(model);
    const PidLayout layout = foundLayout(model);
    PidInput input(layout);
    EXPECT_EQ(input.sample().number, 0U);
    ASSERT_TRUE(input.take(device.inputReport({-1234, 567}, 0b101), 42)) << name(model);
    EXPECT_EQ(input.sample().counts[0], -1234) << name(model);
    if (device.forceAxes() == 2) {
      EXPECT_EQ(input.sample().counts[1], 567) << name(model);
    }
    EXPECT_EQ(input.sample().buttons, 0b101U) << name(model);
    EXPECT_EQ(input.sample().number, 1U);
    EXPECT_EQ(input.sample().time_ns, 42);
    ASSERT_TRUE(input.take(device.inputReport({32767, -32767}, 0), 43));
    EXPECT_EQ(input.sample().counts[0], 32767);
    EXPECT_EQ(input.sample().buttons, 0U);
  }
}

TEST(PidInput, CutReportsMoveNothing) {
  const FakePidDevice device(PidModel::kSketch);
  const PidLayout layout = foundLayout(PidModel::kSketch);
  PidInput input(layout);
  auto report = device.inputReport({100, 200}, 1);
  ASSERT_TRUE(input.take(report, 1));
  report.resize(3);
  input.take(report, 2);
  EXPECT_EQ(input.sample().number, 1U);
  EXPECT_EQ(input.sample().counts[0], 100);
  EXPECT_FALSE(input.take({}, 3));
  EXPECT_FALSE(input.take(std::vector<std::uint8_t>{99, 1, 2, 3}, 3));
}

TEST(PidInput, AnOpenSwitchOrActuatorsOffHoldForcesBack) {
  FakePidDevice device(PidModel::kBoard);
  const PidLayout layout = foundLayout(PidModel::kBoard);
  PidInput input(layout);
  device.output(std::vector<std::uint8_t>{0x0C, 1}, 0);
  ASSERT_TRUE(input.take(device.stateReport(), 1));
  EXPECT_FALSE(input.sample().forces_held_back);
  EXPECT_EQ(input.sample().number, 0U) << "it says nothing of the position";
  device.pressSafetySwitch(true, 2);
  input.take(device.stateReport(), 2);
  EXPECT_TRUE(input.sample().forces_held_back);
  device.pressSafetySwitch(false, 3);
  input.take(device.stateReport(), 3);
  EXPECT_FALSE(input.sample().forces_held_back);
  device.output(std::vector<std::uint8_t>{0x0C, 2}, 4);
  input.take(device.stateReport(), 4);
  EXPECT_TRUE(input.sample().forces_held_back);
}

TEST(PidInput, SwitchesThatTheFirmwareNeverSetsDoNotCount) {
  const PidLayout layout = foundLayout(PidModel::kBoard);
  PidInput input(layout);
  const std::vector<std::uint8_t> only_actuators_on = {0x02, 0x02};
  input.take(only_actuators_on, 1);
  EXPECT_FALSE(input.sample().forces_held_back);
  const std::vector<std::uint8_t> paused = {0x02, 0x03};
  input.take(paused, 2);
  EXPECT_TRUE(input.sample().forces_held_back);
}

/// The sketch says of which block it speaks; 0x10: powered, 2: actuators on.
std::vector<std::uint8_t> sketchState(int block, bool plays) {
  return {2, 0x12, static_cast<std::uint8_t>(block << 1 | (plays ? 1 : 0))};
}

TEST(PidInput, AnEffectThatStopsBetweenStartAndEndHoldsForcesBack) {
  const PidLayout layout = foundLayout(PidModel::kSketch);
  const std::vector<std::int64_t> blocks = {1, 2};
  PidInput input(layout, blocks);
  const auto watch = [&](std::int64_t ms) {
    input.watchEffects(ms * kMs, 0, 90 * kMs);  // started at 0
    return input.sample().forces_held_back;
  };
  input.take(sketchState(2, false), 0);
  EXPECT_FALSE(watch(50)) << "it has not said yet that it tells";
  input.take(sketchState(2, true), 0);
  EXPECT_FALSE(watch(50));
  input.take(sketchState(3, false), 0);
  EXPECT_FALSE(watch(50)) << "the effect of another program";
  input.take(sketchState(2, false), 0);
  EXPECT_FALSE(watch(19)) << "the start may be on its way";
  EXPECT_FALSE(watch(95)) << "the effect has run out, as it should";
  EXPECT_TRUE(watch(20));
  EXPECT_TRUE(watch(5)) << "it was stopped, and nothing has said otherwise";
  input.take(sketchState(2, true), 0);
  EXPECT_FALSE(watch(6));
  input.take(sketchState(1, true), 0);
  input.take(sketchState(0, false), 0);
  EXPECT_TRUE(watch(60)) << "without a block it is about all";
}

}  // namespace
}  // namespace tactus::haptics
