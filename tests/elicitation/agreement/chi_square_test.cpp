#include <cmath>
#include <gtest/gtest.h>

#include "elicitation/agreement/agreement.h"

namespace tactus::elicitation {
namespace {

TEST(ChiSquare, HasTheClosedFormsOfFewDegrees) {
  for (const double x : {0.1, 1.0, 3.841458820694124, 20.0}) {
    EXPECT_DOUBLE_EQ(chiSquareUpperTail(x, 1), std::erfc(std::sqrt(x / 2)));
    EXPECT_DOUBLE_EQ(chiSquareUpperTail(x, 2), std::exp(-x / 2));
    EXPECT_NEAR(chiSquareUpperTail(x, 4), std::exp(-x / 2) * (1 + x / 2), 1e-15);  // rounding
  }
  EXPECT_EQ(chiSquareUpperTail(0, 7), 1);
}

TEST(ChiSquare, AgreesWithScipyFromFewToManyDegrees) {
  struct Case {
    double chi_square;
    int degrees;
    double tail;  // scipy 1.10.1, chi2.sf
  };
  for (const auto& [chi_square, degrees, tail] :
       {Case{0.5, 3, 0.9188914116546758}, Case{30, 7, 9.495972508134177e-05},
        Case{35.7519788918206, 10, 9.284841993021297e-05}, Case{150, 101, 0.0011287104830542635},
        Case{2000, 2000, 0.4957947558197845}, Case{2100, 2000, 0.05867111137731806}}) {
    // A thousand terms, each with the rounding of its logarithm.
    EXPECT_NEAR(chiSquareUpperTail(chi_square, degrees) / tail, 1, 1e-10) << chi_square << ' ' << degrees;
  }
}

TEST(ChiSquare, FarOutIsZeroAndNeverNaN) {
  EXPECT_EQ(chiSquareUpperTail(1e6, 44), 0);
  EXPECT_EQ(chiSquareUpperTail(1e-300, 44), 1);
}

}  // namespace
}  // namespace tactus::elicitation
