#include <gtest/gtest.h>

#include "app/cli/terminal.h"

namespace tactus::cli {
namespace {

TEST(WrappedText, BreaksAtSpacesAndIndents) {
  const std::string word(30, 'a');
  // Four spaces, three words and two spaces make 96; the fourth word does not fit.
  EXPECT_EQ(wrapped(word + ' ' + word + ' ' + word + ' ' + word, "    ", 6),
            "    " + word + ' ' + word + ' ' + word + "\n      " + word + '\n');
  EXPECT_EQ(wrapped("short", "note: ", 6), "note: short\n");
}

TEST(WrappedText, FillsTheLineAndCountsCharactersNotBytes) {
  const std::string half(49, 'a');
  EXPECT_EQ(wrapped(half + ' ' + half + 'b', "", 0), half + ' ' + half + "b\n");  // 100
  EXPECT_EQ(wrapped(half + ' ' + half + "bb", "", 0), half + '\n' + half + "bb\n");
  EXPECT_EQ(wrapped(half + ' ' + half + "±", "", 0), half + ' ' + half + "±\n");
}

TEST(WrappedText, ALongWordStaysWhole) {
  const std::string path(140, 'p');
  EXPECT_EQ(wrapped("in " + path + " here", "", 2), "in\n  " + path + "\n  here\n");
}

TEST(PaddedText, CountsCharactersAndKeepsTheGap) {
  EXPECT_EQ(padded("small", 7), "small  ");
  EXPECT_EQ(padded("größer", 8), "größer  ");  // six characters in eight bytes
  EXPECT_EQ(padded("very_large", 7, 2), "very_large  ");
}

TEST(PaddedText, NumbersEndInOneColumn) {
  EXPECT_EQ(rightAligned("12", 5), "   12");
  EXPECT_EQ(rightAligned("µs", 5), "   µs");
  EXPECT_EQ(rightAligned("largest error", 5), " largest error") << "a gap to the cell before stays";
}

}  // namespace
}  // namespace tactus::cli
