#include <gtest/gtest.h>
#include <vector>

#include "experiments/judgement_checks.h"

namespace tactus::experiments {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

// Married couples' answers on a scale of four (Hout, Duncan and Sobel 1987; table 2.10 in Agresti's "Categorical Data
// Analysis" and the data set SexualFun of R's vcd); with Fleiss-Cohen weights kappa is 0.332.
TEST(WeightedKappa, AgreesWithAPublishedTable) {
  const std::size_t table[4][4] = {{7, 7, 2, 3}, {2, 8, 3, 7}, {1, 5, 4, 9}, {2, 8, 9, 14}};
  Pairs pairs;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) pairs.insert(pairs.end(), table[row][column], {row, column});
  }
  ASSERT_EQ(pairs.size(), 91U);
  EXPECT_NEAR(quadraticWeightedKappa(pairs).value(), 0.332, 0.0005);  // printed to three digits
}

TEST(WeightedKappa, ByHand) {
  // Differences 0, 1, 0: one square of 1. Chance: firsts 0 1 2 against seconds 0 2 2, squares 0 4 4 + 1 1 1 + 4 0 0.
  EXPECT_DOUBLE_EQ(quadraticWeightedKappa(Pairs{{0, 0}, {1, 2}, {2, 2}}).value(), 1 - 1.0 * 3 / 15);
  EXPECT_EQ(quadraticWeightedKappa(Pairs{{0, 0}, {4, 4}}), 1);
  EXPECT_EQ(quadraticWeightedKappa(Pairs{{0, 1}, {1, 0}}), -1);
}

TEST(WeightedKappa, WithoutVariationThereIsNone) {
  EXPECT_FALSE(quadraticWeightedKappa({}).has_value());
  EXPECT_FALSE(quadraticWeightedKappa(Pairs{{2, 2}, {2, 2}}).has_value());
}

}  // namespace
}  // namespace tactus::experiments
