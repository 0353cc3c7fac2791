#include <gtest/gtest.h>
#include <vector>

#include "core/base/text.h"

namespace tactus::base {
namespace {

TEST(CloseMatch, EditsAreCounted) {
  EXPECT_EQ(editDistance("", ""), 0U);
  EXPECT_EQ(editDistance("build", "build"), 0U);
  EXPECT_EQ(editDistance("biuld", "build"), 1U) << "neighbors swapped";
  EXPECT_EQ(editDistance("kitten", "sitting"), 3U);
  EXPECT_EQ(editDistance("", "abc"), 3U);
  EXPECT_EQ(editDistance("SLOW", "slow"), 0U) << "capitals count as small letters";
}

TEST(CloseMatch, TheClosestWordIsTakenWhereItIsClose) {
  const std::vector<std::string> words = {"slow", "medium", "fast", "very_small", "small"};
  EXPECT_EQ(closestWord("meduim", words), "medium");
  EXPECT_EQ(closestWord("smal", words), "small");
  EXPECT_EQ(closestWord("very small", words), "very_small");
  EXPECT_EQ(closestWord("fst", words), "fast");
  EXPECT_EQ(closestWord("zzz", words), "");
  EXPECT_EQ(closestWord("", words), "");
  EXPECT_EQ(closestWord(std::string(100000, 'a'), words), "");
  EXPECT_EQ(suggestion("sloww", words), " (slow?)");
  EXPECT_EQ(suggestion("x", words), "");
}

}  // namespace
}  // namespace tactus::base
