#include "core/analysis/term_conversion.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

using fuzzy::Shape;
using fuzzy::Term;
using Points = std::vector<double>;

Term trapezoid(Points points) { return {"t", "T", Shape::kTrapezoid, std::move(points)}; }

TEST(TermConversion, ATriangleKeepsTheHalvesAndTheArea) {
  // 1/2 at 70 and 115, area 45; the middle of the core is 92.5.
  const auto triangle = convertedTerm(trapezoid({60, 80, 105, 125}), Shape::kTriangle, 0, 600).value();
  EXPECT_EQ(triangle.points, (Points{47.5, 92.5, 137.5}));
  EXPECT_EQ((triangle.points[2] - triangle.points[0]) / 2, 45);
  const auto f = fuzzy::MembershipFunction::of(triangle);
  EXPECT_DOUBLE_EQ(f(70), 0.5);
  EXPECT_DOUBLE_EQ(f(115), 0.5);
}

TEST(TermConversion, AGaussianKeepsTheHalves) {
  const auto gaussian = convertedTerm(trapezoid({60, 80, 105, 125}), Shape::kGaussian, 0, 600).value();
  EXPECT_EQ(gaussian.points[0], 92.5);
  EXPECT_NEAR(gaussian.points[1], 22.5 / 1.1774100225154747, 1e-12);  // sqrt(2 ln 2)
  const auto f = fuzzy::MembershipFunction::of(gaussian);
  EXPECT_NEAR(f(70), 0.5, 1e-15);
  EXPECT_NEAR(f(115), 0.5, 1e-15);
  // And back: 1/2 at the same places, a core of half the width between them, 22.5.
  const auto back = convertedTerm(gaussian, Shape::kTrapezoid, 0, 600).value();
  const Points expected = {92.5 - 33.75, 92.5 - 11.25, 92.5 + 11.25, 92.5 + 33.75};
  for (std::size_t p = 0; p < 4; ++p) EXPECT_NEAR(back.points[p], expected[p], 1e-12);
}

TEST(TermConversion, AShoulderStaysAShoulder) {
  // 1/2 at 70.
  EXPECT_EQ(convertedTerm(trapezoid({0, 0, 60, 80}), Shape::kTriangle, 0, 600)->points, (Points{0, 0, 140}));
  EXPECT_EQ(convertedTerm(trapezoid({420, 460, 600, 600}), Shape::kTriangle, 0, 600)->points, (Points{280, 600, 600}));
  const auto gaussian = convertedTerm(trapezoid({0, 0, 60, 80}), Shape::kGaussian, 0, 600).value();
  EXPECT_EQ(gaussian.points[0], 0);
  EXPECT_NEAR(fuzzy::MembershipFunction::of(gaussian)(70), 0.5, 1e-15);
}

TEST(TermConversion, ATriangleIsATrapezoidAlready) {
  const Term triangle{"t", "T", Shape::kTriangle, {1, 2, 4}};
  EXPECT_EQ(convertedTerm(triangle, Shape::kTrapezoid, 0, 10)->points, (Points{1, 2, 2, 4}));
  EXPECT_EQ(*convertedTerm(triangle, Shape::kTriangle, 0, 10), triangle);
}

TEST(TermConversion, NothingOfNoWidthBecomesAGaussian) {
  EXPECT_FALSE(convertedTerm(trapezoid({3, 3, 3, 3}), Shape::kGaussian, 0, 10));
}

}  // namespace
}  // namespace tactus::analysis
