#include <cmath>
#include <gtest/gtest.h>

#include "experiments/stroke_segmentation.h"

namespace tactus::experiments {
namespace {

// 4 2 0 0
// 2 5 1 0
// 0 1 3 2
// 0 0 2 6
BandMatrix<2> example() {
  BandMatrix<2> matrix(4);
  matrix.at(0, 0) = 4;
  matrix.at(1, 0) = 2;
  matrix.at(1, 1) = 5;
  matrix.at(2, 1) = 1;
  matrix.at(2, 2) = 3;
  matrix.at(3, 2) = 2;
  matrix.at(3, 3) = 6;
  return matrix;
}

TEST(BandMatrix, DeterminantAndSolutionsByHand) {
  auto matrix = example();
  // Elimination leaves the pivots 4, 4, 3 - 1/4 = 11/4 and 6 - 4 / (11/4) = 50/11; their product:
  EXPECT_NEAR(matrix.factorize(), std::log(200.0), 1e-12);
  // x = (1, -2, 3, 0.5): the rows give 0, -5, 8, 9. Beside it the first unit vector: 4, 2, 0, 0.
  std::vector<std::array<double, 2>> x = {{0, 4}, {-5, 2}, {8, 0}, {9, 0}};
  matrix.forward(std::span(x));
  // L⁻¹ of the first right side: 0, -5/2, (8 + 5/4) / √(11/4), ...; its length squared is xᵀ A x.
  EXPECT_NEAR(x[1][0], -2.5, 1e-12);
  EXPECT_NEAR(x[2][0], 9.25 / std::sqrt(2.75), 1e-12);
  double squares = 0;
  for (const auto& row : x) squares += row[0] * row[0];
  EXPECT_NEAR(squares, 1 * 0 + -2 * -5 + 3 * 8 + 0.5 * 9, 1e-12);
  matrix.backward(std::span(x));
  const double wanted[] = {1, -2, 3, 0.5};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(x[i][0], wanted[i], 1e-12);
    EXPECT_NEAR(x[i][1], i == 0 ? 1 : 0, 1e-12);
  }
}

TEST(BandMatrix, AFullMatrixOfTheBandsSizeIsOneToo) {
  // 4 2 -2
  // 2 5  3   Its factor has the rows (2), (1, 2), (-1, 2, 3): the pivots are 4, 4 and 9.
  // -2 3 14
  BandMatrix<3> matrix(3);
  const double lower[3][3] = {{4, 0, 0}, {2, 5, 0}, {-2, 3, 14}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k <= i; ++k) matrix.at(i, k) = lower[i][k];
  }
  EXPECT_NEAR(matrix.factorize(), std::log(144.0), 1e-12);
  const double factor[3][3] = {{2, 0, 0}, {1, 2, 0}, {-1, 2, 3}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k <= i; ++k) EXPECT_NEAR(matrix.at(i, k), factor[i][k], 1e-12);
  }
}

TEST(BandMatrix, WhatIsNotPositiveDefiniteHasNoFactor) {
  auto matrix = example();
  matrix.at(2, 2) = 0.1;
  EXPECT_TRUE(std::isinf(matrix.factorize()));
}

}  // namespace
}  // namespace tactus::experiments
