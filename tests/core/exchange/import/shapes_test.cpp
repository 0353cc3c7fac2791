// Shapes of other programs that trapezoids carry exactly, and those that nothing carries.
#include <cmath>

#include "tests/core/exchange/import/imported.h"

namespace tactus::exchange {
namespace {

/// The term of the input x that a line of FLL gives, used by a rule.
std::vector<double> points(const std::string& shape) {
  const auto from = imported(fll("  rule: if x is t then y is small\n", "  term: t " + shape + "\n"), "a.fll");
  EXPECT_TRUE(from.model) << from.refusal;
  return from.model ? from.model->inputs[0].terms[2].points : std::vector<double>{};
}

std::string refusedShape(const std::string& shape) {
  return imported(fll("  rule: if x is t then y is small\n", "  term: t " + shape + "\n"), "a.fll").refusal;
}

using Points = std::vector<double>;

TEST(ImportedShapes, BecomeTrapezoids) {
  EXPECT_EQ(points("Rectangle 2 3"), (Points{2, 2, 3, 3}));
  EXPECT_EQ(points("Ramp 2 6"), (Points{2, 6, 10, 10}));
  EXPECT_EQ(points("Ramp 6 2"), (Points{0, 0, 2, 6}));
  EXPECT_EQ(points("Ramp 8 12"), (Points{8, 12, 12, 12}));
  EXPECT_EQ(points("linsmf 2 6"), (Points{2, 6, 10, 10}));
  EXPECT_EQ(points("linzmf 2 6"), (Points{0, 0, 2, 6}));
  EXPECT_EQ(points("linsmf 4 4"), (Points{4, 4, 10, 10}));
  // MATLAB: 1 below the step, 0 at it.
  EXPECT_EQ(points("linzmf 4 4"), (Points{0, 0, std::nextafter(4.0, 0.0), std::nextafter(4.0, 0.0)}));
  EXPECT_EQ(points("Binary 4 inf"), (Points{4, 4, 10, 10}));
  EXPECT_EQ(points("Binary 4 -inf"), (Points{0, 0, 4, 4}));
  EXPECT_EQ(points("Discrete 1 0 2 1 5 1 6 0"), (Points{1, 2, 5, 6}));
  EXPECT_EQ(points("Discrete 0 0 1 0 2 1 5 0 9 0"), (Points{1, 2, 2, 5}));
  EXPECT_EQ(points("Discrete 3 1 5 0"), (Points{0, 0, 3, 5}));
  EXPECT_EQ(points("Discrete 3 0 5 1"), (Points{3, 5, 10, 10}));
  EXPECT_EQ(points("Discrete 3 0 3 1 5 1 5 0"), (Points{3, 3, 5, 5}));
  EXPECT_EQ(points("Trapezoid -inf -inf 2 3"), (Points{0, 0, 2, 3}));
  EXPECT_EQ(points("Trapezoid 2 3 inf inf 1.000"), (Points{2, 3, 10, 10}));
  EXPECT_EQ(points("Triangle +1 .5e1 9."), (Points{1, 5, 9}));
  EXPECT_EQ(points("Gaussian 5 2"), (Points{5, 2}));
}

TEST(ImportedShapes, ARuleMayNotUseWhatTactusLacks) {
  EXPECT_EQ(
      refusedShape("Bell 5 2 3"),
      "a.fll: line 8, column 11, term 't': found 'Bell', wanted a trapezoid, a triangle, a Gaussian or points that "
      "make a trapezoid");
  EXPECT_EQ(
      refusedShape("Linear 1 2"),
      "a.fll: line 8, column 11, term 't': found 'Linear', a function of a Takagi-Sugeno system, wanted a trapezoid, "
      "a triangle, a Gaussian or points that make a trapezoid");
  EXPECT_EQ(refusedShape("Rectangle 2 3 0.5"),
            "a.fll: line 8, column 25, term 't': found the height 0.5, wanted the height 1");
  EXPECT_EQ(refusedShape("Discrete 0 0 5 0.5 10 1"),
            "a.fll: line 8, column 26, term 't': found a point of the height 0.5, wanted points that make a trapezoid, "
            "with the heights 0 and 1");
  EXPECT_EQ(refusedShape("Discrete 0 1 5 0 10 1"),
            "a.fll: line 8, column 28, term 't': found points with two peaks, wanted points that make one trapezoid");
}

TEST(ImportedShapes, WhatMakesNoSenseIsRefusedEvenUnused) {
  const auto unused = [](const std::string& shape) {
    return imported(fll("  rule: if x is low then y is small\n", "  term: t " + shape + "\n"), "a.fll").refusal;
  };
  EXPECT_EQ(unused("Trapezoid 0 3 2 5"),
            "a.fll: line 8, column 25, term 't': found 2 after 3, wanted the corners of a term in ascending order");
  EXPECT_EQ(unused("Triangle 0 nan 2"), "a.fll: line 8, column 22, term 't': found nan, wanted a number");
  EXPECT_EQ(unused("Triangle 0 1"), "a.fll: line 8, column 11, term 't': found 'Triangle' with 2 numbers, wanted 3");
  EXPECT_EQ(unused("Triangle 0 1 2 x"), "a.fll: line 8, column 26: found 'x', wanted a number of the term");
  EXPECT_EQ(unused("Gaussian 5 0"), "a.fll: line 8, column 22, term 't': found sigma 0, wanted sigma > 0");
  EXPECT_EQ(unused("Discrete 5 0 2 1"),
            "a.fll: line 8, column 24, term 't': found 2 after 5, wanted points in ascending order");
  EXPECT_EQ(unused("Trapezoid -inf 0 2 3"),
            "a.fll: line 8, column 21, term 't': found -inf, wanted a finite corner, or inf for a whole shoulder");
}

}  // namespace
}  // namespace tactus::exchange
