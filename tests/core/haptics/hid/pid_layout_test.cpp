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

/// The descriptor of a small device, of which one thing can be made wrong.
struct OneAxis {
  std::int64_t magnitude_min = -5000, magnitude_max = 5000;
  std::uint32_t magnitude_bits = 16;
  std::int64_t duration_max = 32767, duration_physical_max = 0;
  std::uint32_t duration_bits = 16, duration_unit = 0x1003;
  int duration_exponent = -3;
  std::int64_t axis_min = -32767, axis_max = 32767;
  std::uint32_t axis_bits = 16;
  int gain_max = 255, constant_id = 5, load_id = 18, first_option = 1, turn = 255;

  base::Result<PidLayout> layout() const {
    using B = support::HidDescriptorBuilder;
    B b;
    b.page(1).usage(4).application().id(1).usage(0x30);
    b.logical(axis_min, axis_max).size(axis_bits).count(1).input(2);
    b.page(0x0F).usage(0x21).collection().id(1).usage(0x22).logical(1, 40).size(8).count(1).output(2);
    b.usage(0x25).collection().usages({0x26, 0x27}).logical(first_option, first_option + 1).output(0).end();
    b.usage(0x50).logical(0, duration_max).physical(0, duration_physical_max).unit(duration_unit);
    b.exponent(duration_exponent).size(duration_bits).output(2).unit(0).exponent(0).physical(0, 0);
    b.usage(0x52).logical(0, gain_max).size(8).output(2);
    b.usage(0x57).collection().page(0x0A).usage(1).logical(0, turn).size(8).output(2).end().page(0x0F).end();
    b.usage(0x73).collection().id(static_cast<std::uint32_t>(constant_id));
    b.usage(0x22).logical(1, 40).size(8).output(2);
    b.usage(0x70).logical(magnitude_min, magnitude_max).size(magnitude_bits).output(2).end();
    b.usage(0x77).collection().id(10).usage(0x22).logical(1, 40).size(8).output(2);
    b.usage(0x78).collection().usages({0x79, 0x7A, 0x7B}).logical(1, 3).output(0).end().end();
    b.usage(0xAB).collection().id(17);
    b.usage(0x25).collection().usages({0x26, 0x27}).logical(1, 2).feature(0).end().end();
    b.usage(0x89).collection().id(static_cast<std::uint32_t>(load_id)).usage(0x22).logical(1, 40).feature(2);
    b.usage(0x8B).collection().usages({0x8C, 0x8D, 0x8E}).logical(1, 3).feature(0).end().end();
    const auto parsed = ReportDescriptor::parse(b.end().take());
    if (!parsed) return tl::unexpected(parsed.error());
    return PidLayout::find(*parsed);
  }
};

TEST(PidLayout, ADescriptorThatLiesIsRefusedInOneSentence) {
  ASSERT_TRUE(OneAxis{}.layout()) << OneAxis{}.layout().error().message();
  const auto refusal = [](auto change) {
    OneAxis device;
    change(device);
    const auto layout = device.layout();
    return layout ? std::string("no refusal") : layout.error().message();
  };
  const std::string magnitude = "report descriptor, magnitude in Set Constant Force: found ";
  EXPECT_EQ(refusal([](OneAxis& d) { d.magnitude_bits = 8; }),
            magnitude + "a range from -5000 to 5000 in 8 bits, wanted a range that fits into its bits");
  EXPECT_EQ(refusal([](OneAxis& d) {
              d.magnitude_min = -127;
              d.magnitude_max = 128;
              d.magnitude_bits = 8;
            }),
            magnitude + "a range from -127 to 128 in 8 bits, wanted a range that fits into its bits");
  EXPECT_EQ(refusal([](OneAxis& d) {
              d.magnitude_min = 0;
              d.magnitude_max = 256;
              d.magnitude_bits = 8;
            }),
            magnitude + "a range from 0 to 256 in 8 bits, wanted a range that fits into its bits");
  EXPECT_EQ(refusal([](OneAxis& d) { d.magnitude_min = d.magnitude_max = 0; }),
            magnitude + "a range from 0 to 0, wanted a range of more than one value");
  EXPECT_NE(refusal([](OneAxis& d) { d.magnitude_min = 6000; }).find("a logical range from 6000 to 5000"),
            std::string::npos);
  EXPECT_EQ(
      refusal([](OneAxis& d) { d.magnitude_bits = 0; }),
      "report descriptor: found no magnitude in Set Constant Force, wanted a force-feedback device (HID PID) that "
      "plays constant forces");

  const std::string duration = "report descriptor, duration in Set Effect: found ";
  const std::string wanted =
      ", wanted 0.09 s to 5 ms, because an effect without an end continues when the program dies";
  EXPECT_EQ(refusal([](OneAxis& d) { d.duration_exponent = 0; }),
            duration + "steps of 1 s up to 32767, in which 0.09 s are 0 s" + wanted);
  EXPECT_EQ(refusal([](OneAxis& d) {
              d.duration_unit = 0x1001;  // seconds of another system of units
              d.duration_exponent = 0;
            }),
            duration + "steps of 1 s up to 32767, in which 0.09 s are 0 s" + wanted);
  EXPECT_EQ(refusal([](OneAxis& d) { d.duration_exponent = -1; }),
            duration + "steps of 0.1 s up to 32767, in which 0.09 s are 0.1 s" + wanted);
  EXPECT_EQ(refusal([](OneAxis& d) { d.duration_max = 50; }),
            duration + "steps of 0.001 s up to 50, in which 0.09 s are 0.05 s" + wanted);
  EXPECT_EQ(refusal([](OneAxis& d) { d.duration_exponent = -6; }),
            duration + "steps of 1e-06 s up to 32767, in which 0.09 s are 0.032767 s" + wanted);
  EXPECT_EQ(refusal([](OneAxis& d) {
              d.duration_max = 100;
              d.duration_physical_max = 1000;
            }),
            duration + "steps of 0.01 s up to 100, in which 0.09 s are 0.9 s" + wanted);
  EXPECT_EQ(refusal([](OneAxis& d) { d.duration_unit = 0x11; }),
            duration + "a unit that is no time, wanted seconds, or no unit");
  EXPECT_EQ(refusal([](OneAxis& d) { d.duration_bits = 8; }),
            duration + "a range from 0 to 32767 in 8 bits, wanted a range that fits into its bits");
  EXPECT_EQ(refusal([](OneAxis& d) { d.duration_exponent = -2; }), "no refusal") << "9 steps";
  EXPECT_EQ(refusal([](OneAxis& d) {
              d.duration_unit = 0;
              d.duration_exponent = 5;
            }),
            "no refusal")
      << "without a unit it counts milliseconds";

  EXPECT_EQ(
      refusal([](OneAxis& d) { d.axis_bits = 8; }),
      "report descriptor, position axis X: found a range from -32767 to 32767 in 8 bits, wanted a range that fits "
      "into its bits");
  EXPECT_EQ(refusal([](OneAxis& d) { d.gain_max = 0; }),
            "report descriptor, gain in Set Effect: found a range from 0 to 0, wanted a range of more than one value");
  EXPECT_EQ(
      refusal([](OneAxis& d) { d.turn = 0; }),
      "report descriptor, direction in Set Effect: found a range from 0 to 0, wanted a range of more than one value");
  EXPECT_EQ(refusal([](OneAxis& d) { d.first_option = 300; }),
            "report descriptor, constant force among the effect types: found the number 300 in 8 bits, wanted a number "
            "that fits into its bits");
  EXPECT_EQ(refusal([](OneAxis& d) { d.constant_id = 1; }),
            "report descriptor, Set Effect and Set Constant Force: found the same report id 1, wanted an id for each");
  EXPECT_EQ(
      refusal([](OneAxis& d) { d.load_id = 17; }),
      "report descriptor, Create New Effect and PID Block Load: found the same report id 17, wanted an id for each");
}

}  // namespace
}  // namespace tactus::haptics
