#include "app/dataset/tsv.h"

#include <gtest/gtest.h>

namespace tactus::dataset {
namespace {

TEST(Tsv, MissingIsSaidAndNoCellBreaksTheTable) {
  TsvWriter table({"a", "b"});
  table.row({"", "one\ttwo\nthree"});
  EXPECT_EQ(table.text(), "a\tb\nn/a\tone two three\n");
}

TEST(Tsv, EqualNumbersGetDifferentTextsAndKeepTheirValues) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(differentTexts({"0", "0", "0"}), (Texts{"0", "0.0", "0.00"}));
  EXPECT_EQ(differentTexts({"0.5", "2", "0.5"}), (Texts{"0.5", "2", "0.50"}));
  EXPECT_EQ(differentTexts({"1e-07", "1e-07"}), (Texts{"1e-07", "1.0e-07"}));
  EXPECT_EQ(differentTexts({"0.0", "0", "0"}), (Texts{"0.0", "0", "0.00"}));
}

TEST(Labels, AreLettersAndDigitsAndOneForEachText) {
  Labels labels;
  EXPECT_EQ(labels.of("very slow"), "veryslow");
  EXPECT_EQ(labels.of("very_slow"), "veryslowx2");
  EXPECT_EQ(labels.of("very slow"), "veryslow");
  EXPECT_EQ(labels.of("慢"), "x");
}

}  // namespace
}  // namespace tactus::dataset
