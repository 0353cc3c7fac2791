#include <gtest/gtest.h>

#include "core/study/record_id.h"

namespace tactus::study {
namespace {

TEST(CodeKey, SpellingsThatAPersonTakesForOneAreOne) {
  for (const char* code : {"S1", "s1", " S 1 ", "S-1", "s_01", "S.001",
                           "S\xE2\x80\x93"
                           "1",
                           "S\xC2\xA0"
                           "1",
                           "\xEF\xBC\xB3\xEF\xBC\x91"}) {
    EXPECT_EQ(codeKey(code), "s1") << code;
  }
}

TEST(CodeKey, NumbersKeepTheirDigits) {
  EXPECT_EQ(codeKey("S10"), "s10");
  EXPECT_EQ(codeKey("S100"), "s100");
  EXPECT_EQ(codeKey("S0"), "s0");
  EXPECT_EQ(codeKey("S00"), "s0");
  EXPECT_EQ(codeKey("007"), "7");
  EXPECT_EQ(codeKey("A0B0"), "a0b0");
  EXPECT_NE(codeKey("S1"), codeKey("S11"));
  EXPECT_EQ(codeKey(""), "");
}

TEST(CodeKey, OtherLettersStay) {
  EXPECT_EQ(codeKey("Ä1"), "Ä1");
  EXPECT_NE(codeKey("甲1"), codeKey("乙1"));
  EXPECT_EQ(codeKey("x\xC3"), "x\xC3") << "a cut character is no reason to read beyond the end";
}

}  // namespace
}  // namespace tactus::study
