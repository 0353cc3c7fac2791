#include "experiments/bordered_matrix.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tactus::experiments {
namespace {

// 4 2 0 1
// 2 5 1 0     A band of two, then one full row.
// 0 1 3 2
// 1 0 2 6
BorderedMatrix example() {
  BorderedMatrix matrix(4, 2, 1);
  matrix.at(0, 0) = 4;
  matrix.at(1, 0) = 2;
  matrix.at(1, 1) = 5;
  matrix.at(2, 1) = 1;
  matrix.at(2, 2) = 3;
  matrix.at(3, 0) = 1;
  matrix.at(3, 2) = 2;
  matrix.at(3, 3) = 6;
  return matrix;
}

TEST(BorderedMatrix, DeterminantAndSolutionByHand) {
  auto matrix = example();
  // Elimination leaves the pivots 4, 4, 3 - 1/4 = 11/4 and 6 - 1/4 - 1/16 - (17/8)^2 / (11/4) = 89/22; their product:
  EXPECT_NEAR(matrix.factorize(), std::log(178.0), 1e-12);
  // x = (1, -2, 3, 0.5): the rows give 0.5, -5, 8, 10.
  const auto x = matrix.solve({0.5, -5, 8, 10});
  const double wanted[] = {1, -2, 3, 0.5};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(x[i], wanted[i], 1e-12);
}

TEST(BorderedMatrix, WhatIsNotPositiveDefiniteHasNoFactor) {
  auto matrix = example();
  matrix.at(2, 2) = 0.1;
  EXPECT_TRUE(std::isinf(matrix.factorize()));
}

}  // namespace
}  // namespace tactus::experiments
