#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "core/haptics/hid/pid_layout.h"

namespace tactus::haptics {
namespace {

TEST(ValueSlot, BitsLieLowestFirstAfterTheId) {
  std::vector<std::uint8_t> report = {0x11, 0xFF, 0x00, 0xFF};
  putValue(report, {.bit_offset = 6, .bit_size = 10, .logical_min = 0, .logical_max = 511}, 0x155);
  // 0x155 = 01 0101 0101: its low two bits (01) on top of byte 1, the other eight (0101 0101) in byte 2.
  EXPECT_EQ(report, (std::vector<std::uint8_t>{0x11, 0x7F, 0x55, 0xFF}));
  EXPECT_EQ(takeValue(report, {.bit_offset = 6, .bit_size = 10}), 0x155);
}

TEST(ValueSlot, NegativeValuesComeBackWhereTheRangeHasThem) {
  std::vector<std::uint8_t> report(4);
  const ValueSlot with_sign{.bit_offset = 3, .bit_size = 16, .logical_min = -32767, .logical_max = 32767};
  for (const std::int64_t value : {-32767, -1, 0, 1, 32767}) {
    putValue(report, with_sign, value);
    EXPECT_EQ(takeValue(report, with_sign), value);
  }
  const ValueSlot widest{.bit_offset = 0, .bit_size = 32, .logical_min = -2147483648LL, .logical_max = 2147483647};
  report.resize(5);
  putValue(report, widest, -2147483648LL);
  EXPECT_EQ(takeValue(report, widest), -2147483648LL);
}

TEST(ValueSlot, NothingOutsideTheReportIsTouched) {
  std::array<std::uint8_t, 4> bytes = {1, 0, 0xAA, 0xAA};
  const std::span<std::uint8_t> report(bytes.data(), 2);
  putValue(report, {.bit_offset = 4, .bit_size = 16}, 0xFFFF);
  EXPECT_EQ(bytes, (std::array<std::uint8_t, 4>{1, 0xF0, 0xAA, 0xAA}));
  EXPECT_EQ(takeValue(report, {.bit_offset = 4, .bit_size = 16}), 0xF);
  EXPECT_EQ(takeValue({}, {.bit_offset = 0, .bit_size = 8}), 0);
}

TEST(ValueSlot, SharesAreScaledByTheEndOfTheirSignAndClamped) {
  const ValueSlot two_sided{.bit_size = 16, .logical_min = -10000, .logical_max = 10000};
  EXPECT_EQ(rawOfShare(two_sided, 0.25), 2500);
  EXPECT_EQ(rawOfShare(two_sided, -0.25), -2500);
  EXPECT_EQ(rawOfShare(two_sided, 1.2345), 10000);
  EXPECT_EQ(rawOfShare(two_sided, -99), -10000);
  EXPECT_EQ(rawOfShare(two_sided, std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(rawOfShare(two_sided, std::numeric_limits<double>::infinity()), 10000);
  const ValueSlot uneven{.bit_size = 8, .logical_min = -128, .logical_max = 127};
  EXPECT_EQ(rawOfShare(uneven, -1), -128);
  const ValueSlot one_sided{.bit_size = 16, .logical_min = 0, .logical_max = 10000};
  EXPECT_EQ(rawOfShare(one_sided, 0.5), 5000);
  EXPECT_EQ(rawOfShare(one_sided, -0.5), 0);
}

TEST(ValueSlot, TimesFollowTheUnitOfTheField) {
  EXPECT_EQ(rawOfTime({.bit_size = 16, .logical_max = 32767, .unit_exponent = -3, .unit = 0x1003}, 0.1), 100);
  EXPECT_EQ(rawOfTime({.bit_size = 16, .logical_max = 32767, .unit_exponent = -4, .unit = 0x1003}, 0.1), 1000);
  EXPECT_EQ(rawOfTime({.bit_size = 16, .logical_max = 32767}, 0.1), 100) << "without a unit: milliseconds";
  EXPECT_EQ(rawOfTime({.bit_size = 8, .logical_max = 50}, 0.1), 50);
}

TEST(ValueSlot, AnglesFillOneTurn) {
  EXPECT_EQ(rawOfAngle({.bit_size = 16, .logical_max = 36000}, 90), 9000);
  EXPECT_EQ(rawOfAngle({.bit_size = 16, .logical_max = 35999}, 270), 27000) << "0 stands for 360 degrees too";
  EXPECT_EQ(rawOfAngle({.bit_size = 8, .logical_max = 255}, 90), 64) << "63.75";
  EXPECT_EQ(allOnes({.bit_size = 8}), 255);
}

}  // namespace
}  // namespace tactus::haptics
