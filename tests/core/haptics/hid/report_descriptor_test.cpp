#include "core/haptics/hid/report_descriptor.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/haptics/hid/hid_pid_device.h"
#include "core/haptics/hid/pid_layout.h"

#include "tests/support/fake_pid_device.h"
#include "tests/support/hid_descriptor_builder.h"

namespace tactus::haptics {
namespace {

using support::HidDescriptorBuilder;
constexpr int kVar = HidDescriptorBuilder::kVariable;

std::string refusal(const std::vector<std::uint8_t>& bytes) {
  const auto parsed = ReportDescriptor::parse(bytes);
  return parsed ? "accepted" : parsed.error().message();
}

TEST(ReportDescriptor, CountsBitsPerTypeAndId) {
  HidDescriptorBuilder b;
  b.page(1).usage(4).application().id(5).usages({0x30, 0x31}).logical(-127, 127).size(8).count(2).input(kVar);
  b.usage(0x32).size(12).count(1).output(kVar).id(6).usage(0x33).output(kVar).id(5).usage(0x34).size(3).output(kVar);
  const auto parsed = ReportDescriptor::parse(b.end().take());
  ASSERT_TRUE(parsed) << parsed.error().message();
  ASSERT_EQ(parsed->fields().size(), 4U);
  EXPECT_EQ(parsed->fields()[0].bit_offset, 0U);
  EXPECT_EQ(parsed->fields()[1].bit_offset, 0U) << "the output report with the same id begins anew";
  EXPECT_EQ(parsed->fields()[2].bit_offset, 0U);
  EXPECT_EQ(parsed->fields()[3].bit_offset, 12U) << "after the 12 bits of the same report";
  EXPECT_EQ(parsed->reportBytes(ReportType::kInput, 5), 3U);
  EXPECT_EQ(parsed->reportBytes(ReportType::kOutput, 5), 3U) << "id, and 15 bits";
  EXPECT_EQ(parsed->reportBytes(ReportType::kOutput, 6), 3U);
  EXPECT_EQ(parsed->reportBytes(ReportType::kFeature, 5), 0U);
  EXPECT_TRUE(parsed->numbered());
}

TEST(ReportDescriptor, AMaximumIsSignedOnlyBesideANegativeMinimum) {
  HidDescriptorBuilder b;
  b.page(1).usage(4).application().size(16).count(1);
  b.usage(0x30).raw({0x15, 0x00, 0x25, 0xFF}).input(kVar);                          // 0, 1-byte FF
  b.usage(0x31).raw({0x15, 0x00, 0x27, 0xFF, 0xFF, 0x00, 0x00}).input(kVar);        // 0, 4-byte FFFF
  b.usage(0x32).raw({0x15, 0x81, 0x25, 0x7F}).input(kVar);                          // -127, 127
  b.usage(0x33).raw({0x16, 0x00, 0x80, 0x26, 0xFF, 0xFF}).input(kVar);              // -32768, -1
  b.usage(0x34).raw({0x14, 0x27, 0xFF, 0xFF, 0xFF, 0xFF, 0x55, 0x0E}).input(kVar);  // no byte: 0; exponent -2
  const auto parsed = ReportDescriptor::parse(b.end().take());
  ASSERT_TRUE(parsed) << parsed.error().message();
  const auto& fields = parsed->fields();
  EXPECT_EQ(fields[0].logical_max, 255);
  EXPECT_EQ(fields[1].logical_max, 65535);
  EXPECT_EQ(fields[2].logical_min, -127);
  EXPECT_EQ(fields[2].logical_max, 127);
  EXPECT_EQ(fields[3].logical_min, -32768);
  EXPECT_EQ(fields[3].logical_max, -1);
  EXPECT_EQ(fields[4].logical_max, 4294967295);
  EXPECT_EQ(fields[4].unit_exponent, -2);
  EXPECT_FALSE(parsed->numbered());
}

TEST(ReportDescriptor, UsagesCarryTheirPageOrTakeTheOneInForce) {
  HidDescriptorBuilder b;
  b.page(9).usage(1).application().size(1).count(6).logical(0, 1);
  b.longUsage(0x0F, 0x9F).usageRange(3, 5).usage(0x30).page(1).input(kVar);
  const auto parsed = ReportDescriptor::parse(b.end().take());
  ASSERT_TRUE(parsed) << parsed.error().message();
  const HidField& field = parsed->fields().front();
  EXPECT_EQ(field.path.front(), (Usage{9, 1}));
  EXPECT_EQ(field.usageCount(), 5U);
  EXPECT_EQ(field.usageAt(0), (Usage{0x0F, 0x9F}));
  EXPECT_EQ(field.usageAt(1), (Usage{1, 3})) << "the page at the main item counts";
  EXPECT_EQ(field.usageAt(3), (Usage{1, 5}));
  EXPECT_EQ(field.usageAt(4), (Usage{1, 0x30}));
  EXPECT_EQ(field.usageAt(5), (Usage{1, 0x30})) << "the last usage holds for all that follow";
  EXPECT_EQ(field.indexOf({1, 4}), 2U);
  EXPECT_EQ(field.indexOf({9, 4}), std::nullopt);
}

TEST(ReportDescriptor, PushAndPopKeepTheGlobals) {
  HidDescriptorBuilder b;
  b.page(1).usage(4).application().logical(-5, 5).size(4).count(1).push().page(9).logical(0, 1).size(1).id(7);
  b.usage(1).input(kVar).pop().usage(0x30).input(kVar);
  const auto parsed = ReportDescriptor::parse(b.end().take());
  ASSERT_TRUE(parsed) << parsed.error().message();
  EXPECT_EQ(parsed->fields()[0].report_id, 7);
  EXPECT_EQ(parsed->fields()[1].report_id, 0);
  EXPECT_EQ(parsed->fields()[1].logical_min, -5);
  EXPECT_EQ(parsed->fields()[1].usageAt(0), (Usage{1, 0x30}));
}

TEST(ReportDescriptor, LongItemsAreSkippedAndOfAlternativesTheFirstCounts) {
  HidDescriptorBuilder b;
  b.page(1).usage(4).application().raw({0xFE, 3, 0x42, 0xC0, 0xC0, 0xC0}).size(8).count(1).logical(0, 1);
  b.raw({0xA9, 1}).usage(0x30).usage(0x31).raw({0xA9, 0}).input(kVar);
  const auto parsed = ReportDescriptor::parse(b.end().take());
  ASSERT_TRUE(parsed) << parsed.error().message();
  EXPECT_EQ(parsed->fields().front().usageCount(), 1U);
  EXPECT_EQ(parsed->fields().front().usageAt(0), (Usage{1, 0x30}));
}

TEST(ReportDescriptor, RefusesWhatDoesNotFitTogether) {
  EXPECT_EQ(refusal({}), "report descriptor, byte 0: found nothing, wanted at least one item");
  EXPECT_EQ(refusal({0x05, 0x01, 0x09}),
            "report descriptor, byte 2: found item 0x09 that is cut off, wanted all its bytes");
  EXPECT_EQ(refusal({0xFE, 9, 1, 2}),
            "report descriptor, byte 0: found a long item that is cut off, wanted all its bytes");
  EXPECT_EQ(refusal({0xC0}),
            "report descriptor, byte 0: found the end of a collection, wanted its beginning before it");
  EXPECT_EQ(refusal({0xA1, 0x01}),
            "report descriptor, byte 2: found 1 open collections at the end, wanted all of them closed");
  EXPECT_EQ(refusal({0xB4}), "report descriptor, byte 0: found a pop, wanted a push before it");
  EXPECT_EQ(refusal({0x85, 0x00}), "report descriptor, byte 0: found report id 0, wanted 1 to 255");
  EXPECT_EQ(refusal({0x29, 0x03}),
            "report descriptor, byte 0: found a usage maximum, wanted a usage minimum before it");
  EXPECT_EQ(refusal({0x0D, 0x03}),
            "report descriptor, byte 0: found item 0x0d of the reserved type, wanted a main, global or local item");
  EXPECT_EQ(refusal({0x75, 8, 0x95, 1, 0x15, 5, 0x25, 2, 0x81, 2}),
            "report descriptor, byte 8: found a logical range from 5 to 2, wanted minimum first");
  EXPECT_EQ(refusal({0x77, 0xFF, 0xFF, 0xFF, 0xFF}),
            "report descriptor, byte 0: found values of 4294967295 bits, wanted at most 256 bits");
  EXPECT_EQ(refusal(std::vector<std::uint8_t>(5000, 0x09)),
            "report descriptor, byte 0: found 5000 bytes, wanted at most 4096 bytes");
}

TEST(ReportDescriptor, RefusesReportsWithoutEndAndNestingWithoutEnd) {
  HidDescriptorBuilder big;
  big.size(255).count(12000).output(kVar);
  EXPECT_NE(refusal(big.take()).find("at most 8192 bytes"), std::string::npos);
  EXPECT_NE(refusal(std::vector<std::uint8_t>(33 * 2, 0xA1)).find("32 collections"), std::string::npos);
  EXPECT_NE(refusal(std::vector<std::uint8_t>(33, 0xA4)).find("32 pushed states"), std::string::npos);
}

/// Whatever the bytes are, each step either refuses or stays inside them (the sanitizers and assertions watch).
void useAll(const std::vector<std::uint8_t>& bytes, base::Random& random) {
  const auto parsed = ReportDescriptor::parse(bytes);
  if (!parsed) {
    EXPECT_FALSE(parsed.error().message().empty());
    return;
  }
  const auto layout = PidLayout::find(*parsed);
  if (!layout) return;
  auto report = layout->set_effect.report.blank();
  putValue(report, layout->set_effect.duration, 100);
  report = layout->constant_force.report.blank();
  putValue(report, layout->constant_force.magnitude, rawOfShare(layout->constant_force.magnitude, -0.3));
  takeValue(report, layout->constant_force.magnitude);
  PidInput input(*layout);
  std::vector<std::uint8_t> in(static_cast<std::size_t>(random.below(70)));
  for (auto& byte : in) byte = static_cast<std::uint8_t>(random.below(256));
  if (!in.empty() && layout->axes[0]) in[0] = layout->axes[0]->report_id;
  input.take(in, 0);
}

TEST(ReportDescriptor, SurvivesRandomChangesOfRealLayouts) {
  base::Random random(20261121);
  for (const auto model : support::kPidModels) {
    const auto whole = support::reportDescriptor(model);
    for (int round = 0; round < 4000; ++round) {
      auto bytes = whole;
      const int changes = 1 + random.below(4);
      for (int i = 0; i < changes && !bytes.empty(); ++i) {
        const auto at = bytes.begin() + random.below(static_cast<int>(bytes.size()));
        switch (random.below(4)) {
          case 0: *at = static_cast<std::uint8_t>(random.below(256)); break;
          case 1: *at ^= static_cast<std::uint8_t>(1 << random.below(8)); break;
          case 2: bytes.erase(at); break;
          default: bytes.insert(at, static_cast<std::uint8_t>(random.below(256)));
        }
      }
      useAll(bytes, random);
    }
    // Six bytes are page, usage and the first collection; a page and a usage alone are a whole descriptor.
    for (std::size_t length = 5; length < whole.size(); ++length) {
      EXPECT_FALSE(ReportDescriptor::parse(std::span(whole).first(length))) << "cut after " << length;
    }
  }
  for (int round = 0; round < 4000; ++round) {
    std::vector<std::uint8_t> noise(static_cast<std::size_t>(random.below(200)));
    for (auto& byte : noise) byte = static_cast<std::uint8_t>(random.below(256));
    useAll(noise, random);
  }
}

}  // namespace
}  // namespace tactus::haptics
