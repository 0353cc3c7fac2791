#include <gtest/gtest.h>

#include "core/base/text.h"

namespace tactus::base {
namespace {

TEST(RoundedNumber, HidesTheDigitsThatNobodyMeans) {
  EXPECT_EQ(roundedNumber(0.15000000000000002), "0.15");
  EXPECT_EQ(roundedNumber(0.1 + 0.2), "0.3");
  EXPECT_EQ(roundedNumber(-1.0 / 3), "-0.3333");
  EXPECT_EQ(roundedNumber(500), "500");
  EXPECT_EQ(roundedNumber(0), "0");
}

TEST(RoundedNumber, KeepsWhatRoundingWouldHide) {
  EXPECT_EQ(roundedNumber(1e-5), "1e-05");
  EXPECT_EQ(roundedNumber(1e160), "1e+160");
}

}  // namespace
}  // namespace tactus::base
