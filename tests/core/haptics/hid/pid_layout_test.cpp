#include "core/haptics/hid/pid_layout.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/fake_pid_device.h"
#include "tests/support/hid_descriptor_builder.h"

namespace tactus::haptics {
namespace {

using support::PidModel;

PidLayout layoutOf(PidModel model) {
  const auto parsed = ReportDescriptor::parse(support::reportDescriptor(model));
  EXPECT_TRUE(parsed) << parsed.error().message();
  const auto layout = PidLayout::find(*parsed);
  EXPECT_TRUE(layout) << layout.error().message();
  return *layout;
}

/// Byte of a value, the id being byte 0.
std::uint32_t byteOf(const ValueSlot& slot) { return 1 + slot.bit_offset / 8; }

// The expected bytes of all three are those of the tables that the models were laid out by.
TEST(PidLayout, FindsTheBytesOfTheBoard) {
  const PidLayout layout = layoutOf(PidModel::kBoard);
  EXPECT_EQ(layout.set_effect.report, (PidReport{0x01, 22}));
  EXPECT_EQ(byteOf(layout.set_effect.block), 1U);
  EXPECT_EQ(byteOf(layout.set_effect.constant_force.slot), 2U);
  EXPECT_EQ(layout.set_effect.constant_force.value, 1);
  EXPECT_EQ(byteOf(layout.set_effect.duration), 3U);
  EXPECT_EQ(byteOf(*layout.set_effect.gain), 11U);
  EXPECT_EQ(byteOf(*layout.set_effect.trigger_button), 12U);
  ASSERT_EQ(layout.set_effect.axes_enable.size(), 2U);
  EXPECT_EQ(layout.set_effect.axes_enable[1].bit_offset, 12U * 8 + 1);
  EXPECT_EQ(layout.set_effect.direction_enable->bit_offset, 12U * 8 + 2);
  EXPECT_EQ(byteOf(layout.set_effect.directions.at(0)), 14U);
  EXPECT_EQ(byteOf(layout.set_effect.directions.at(1)), 16U);
  EXPECT_EQ(layout.constant_force.report, (PidReport{0x05, 4}));
  EXPECT_EQ(layout.constant_force.magnitude.logical_min, -32767);
  EXPECT_FALSE(layout.signByDirection());
  EXPECT_EQ(layout.operation.report, (PidReport{0x0A, 4}));
  EXPECT_EQ(layout.operation.start.value, 1);
  EXPECT_EQ(layout.operation.stop.value, 3);
  EXPECT_EQ(byteOf(*layout.operation.loop_count), 3U);
  EXPECT_EQ(layout.block_free->report, (PidReport{0x0B, 2}));
  EXPECT_EQ(layout.control->report, (PidReport{0x0C, 2}));
  EXPECT_EQ(*layout.control->reset, (PidChoice{layout.control->reset->slot, 1})) << "a bit of a mask";
  EXPECT_EQ(layout.control->reset->slot.bit_offset, 3U);
  EXPECT_EQ(layout.control->disable->slot.bit_offset, 1U);
  EXPECT_EQ(layout.gain->report, (PidReport{0x0D, 2}));
  EXPECT_EQ(layout.create.report, (PidReport{0x11, 4}));
  EXPECT_EQ(layout.block_load.report, (PidReport{0x12, 5}));
  EXPECT_EQ(layout.block_load.full->value, 2);
  EXPECT_EQ(*layout.pool, (PidReport{0x13, 5}));
  EXPECT_EQ(layout.force_axes, 2);
  EXPECT_EQ(layout.axes[0]->report_id, 1);
  EXPECT_EQ(byteOf(layout.axes[0]->slot), 9U);
  EXPECT_EQ(byteOf(layout.axes[1]->slot), 11U);
  EXPECT_EQ(layout.buttons[31]->slot.bit_offset, 31U);
  EXPECT_EQ(layout.state->report_id, 2);
  EXPECT_EQ(layout.state->power->bit_offset, 3U);
}

TEST(PidLayout, FindsTheBytesOfTheSketch) {
  const PidLayout layout = layoutOf(PidModel::kSketch);
  EXPECT_EQ(layout.set_effect.report, (PidReport{1, 18}));
  EXPECT_EQ(byteOf(*layout.set_effect.gain), 9U);
  EXPECT_EQ(layout.set_effect.direction_enable->bit_offset, 10U * 8 + 2);
  EXPECT_EQ(byteOf(layout.set_effect.directions.at(0)), 12U);
  EXPECT_EQ(layout.set_effect.directions.at(0).bit_size, 8U);
  EXPECT_EQ(layout.constant_force.report, (PidReport{5, 4}));
  EXPECT_EQ(layout.create.report, (PidReport{5, 4})) << "the same id as a report of another type";
  EXPECT_EQ(layout.constant_force.magnitude.logical_max, 10000);
  EXPECT_EQ(layout.control->enable->slot.bit_size, 8U);
  EXPECT_EQ(layout.control->enable->value, 1);
  EXPECT_EQ(layout.control->disable->value, 2);
  EXPECT_EQ(layout.control->reset->value, 4);
  EXPECT_EQ(layout.axes[0]->report_id, 3);
  EXPECT_EQ(byteOf(layout.axes[1]->slot), 4U);
  EXPECT_EQ(layout.force_axes, 2);
}

TEST(PidLayout, FindsTheBytesOfTheWheel) {
  const PidLayout layout = layoutOf(PidModel::kWheel);
  EXPECT_EQ(layout.set_effect.report, (PidReport{0x41, 11}));
  EXPECT_EQ(layout.set_effect.constant_force.value, 3) << "third in the list of this device";
  EXPECT_EQ(byteOf(*layout.set_effect.gain), 5U);
  EXPECT_EQ(byteOf(layout.set_effect.directions.at(0)), 9U);
  EXPECT_TRUE(layout.signByDirection());
  EXPECT_EQ(layout.control->enable->value, 2) << "the order of the list counts, and 0 is none";
  EXPECT_EQ(layout.control->disable->value, 1);
  EXPECT_FALSE(layout.pool);
  EXPECT_FALSE(layout.state);
  EXPECT_EQ(layout.force_axes, 1);
  EXPECT_EQ(byteOf(layout.axes[0]->slot), 1U);
  EXPECT_TRUE(layout.buttons[11]);
  EXPECT_FALSE(layout.buttons[12]);
}

TEST(PidLayout, SaysInOneSentenceWhatIsMissing) {
  support::HidDescriptorBuilder b;
  b.page(1).usage(4).application().id(1).page(0x0F).usage(0x21).collection();
  b.usage(0x22).logical(1, 9).size(8).count(1).output(2).end();
  const auto parsed = ReportDescriptor::parse(b.end().take());
  ASSERT_TRUE(parsed);
  EXPECT_TRUE(claimsPid(*parsed));
  EXPECT_EQ(PidLayout::find(*parsed).error().message(),
            "report descriptor: found no constant force among the effect types, no duration in Set Effect, no Set "
            "Constant Force report, no Effect Operation report, no Create New Effect report, no PID Block Load report, "
            "no position axis (X, Y, Z), wanted a force-feedback device (HID PID) that plays constant forces");
}

TEST(PidLayout, AMouseIsNoForceFeedbackDevice) {
  support::HidDescriptorBuilder b;
  b.page(1).usage(2).application().usages({0x30, 0x31}).logical(-127, 127).size(8).count(2).input(2);
  const auto parsed = ReportDescriptor::parse(b.end().take());
  ASSERT_TRUE(parsed);
  EXPECT_FALSE(claimsPid(*parsed));
  EXPECT_EQ(PidLayout::find(*parsed).error().message(),
            "report descriptor: found no force-feedback reports, wanted a force-feedback device (HID PID)");
}

}  // namespace
}  // namespace tactus::haptics
