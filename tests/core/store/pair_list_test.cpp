#include <gtest/gtest.h>

#include "core/store/query.h"

namespace tactus::store {
namespace {

TEST(PairList, ReadsBackWhatItWrote) {
  const PairList pairs = {{"depth", "mm"}, {"a \"quoted\" name", ""}};
  EXPECT_EQ(pairListText(pairs), R"([["depth", "mm"], ["a \"quoted\" name", ""]])");
  EXPECT_EQ(pairListIn(pairListText(pairs)), pairs);
  EXPECT_EQ(pairListText({}), "[]");
  EXPECT_EQ(pairListIn("[]"), PairList());
}

TEST(PairList, RefusesEverythingElse) {
  for (const char* text : {"", "{}", "\"depth\"", R"(["depth", "mm"])", R"([["depth"]])", R"([["depth", 1]])",
                           R"([["a", "b", "c"]])", R"([["depth", "mm"])"}) {
    EXPECT_FALSE(pairListIn(text)) << text;
  }
}

}  // namespace
}  // namespace tactus::store
