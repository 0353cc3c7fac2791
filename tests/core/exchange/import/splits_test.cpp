// OR, NOT and groups, split into rules and terms: the strengths are those of minimum, maximum and 1 - x.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/core/exchange/import/imported.h"

namespace tactus::exchange {
namespace {

double low(double x) { return std::clamp((4 - x) / 2, 0.0, 1.0); }
double high(double x) { return 1 - low(x); }

/// The rule `if CONDITION then y is small` beside `if x is any of its terms then y is large with 1`: the strength s of
/// the first follows from the force (2 s + 6) / (s + 1).
void expectStrength(const std::string& condition, double (*strength)(double, double)) {
  SCOPED_TRACE(condition);
  const std::string whole = "  term: whole Rectangle 0 10\n";
  const auto from = imported(
      fll("  rule: if " + condition + " then y is small\n  rule: if x is whole then y is large\n", whole), "a.fll");
  ASSERT_TRUE(from.model) << from.refusal;
  for (double x = 0; x <= 10; x += 0.25) {
    for (double z = 0; z <= 10; z += 0.25) {
      const double s = strength(x, z);
      ASSERT_NEAR(force(from, {x, z}), (2 * s + 6) / (s + 1), 1e-12) << x << ", " << z;
    }
  }
}

TEST(ImportedRules, AreSplitExactly) {
  expectStrength("x is low or z is low", [](double x, double z) { return std::max(low(x), low(z)); });
  expectStrength("x is not low", [](double x, double) { return 1 - low(x); });
  expectStrength("x is not not low", [](double x, double) { return low(x); });
  expectStrength("x is low and z is not high", [](double x, double z) { return std::min(low(x), 1 - high(z)); });
  // AND binds closer than OR.
  expectStrength("x is low or x is high and z is low",
                 [](double x, double z) { return std::max(low(x), std::min(high(x), low(z))); });
  expectStrength("(x is low or x is high) and z is low",
                 [](double x, double z) { return std::min(std::max(low(x), high(x)), low(z)); });
  expectStrength("not (x is low and z is low)", [](double x, double z) { return 1 - std::min(low(x), low(z)); });
  expectStrength("not (x is low or not (z is low))",
                 [](double x, double z) { return 1 - std::max(low(x), 1 - low(z)); });
}

TEST(ImportedRules, AnyAlwaysHolds) {
  expectStrength("x is any and z is low", [](double, double z) { return low(z); });
  expectStrength("x is low and z is any", [](double x, double) { return low(x); });
  expectStrength("x is not any or z is low", [](double, double z) { return low(z); });
  expectStrength("not (x is any and z is low)", [](double, double z) { return 1 - low(z); });
  const std::string high = "  rule: if x is high then y is large\n";
  EXPECT_EQ(
      imported(fll("  rule: if x is any then y is small\n" + high), "a.fll").refusal,
      "a.fll: line 28, column 9: found a rule whose condition asks for no term, wanted a term of one input or more");
  const auto never = imported(fll("  rule: if x is not any then y is small\n" + high), "a.fll");
  EXPECT_FALSE(fires(never, {0, 0}));
  // A term may have this name.
  const auto term = imported(fll("  rule: if x is any then y is small\n", "  term: any Triangle 4 5 6\n"), "a.fll");
  EXPECT_FALSE(fires(term, {0, 0}));
  EXPECT_TRUE(fires(term, {5, 0}));
}

TEST(ImportedRules, NotOfATriangleIsTwoTerms) {
  const auto from = imported(fll("  rule: if x is not mid then y is small\n", "  term: mid Triangle 2 5 8\n"), "a.fll");
  ASSERT_TRUE(from.model) << from.refusal;
  const auto& terms = from.model->inputs[0].terms;
  ASSERT_EQ(terms.size(), 5U);
  EXPECT_EQ(terms[3].id, "not_mid_below");
  EXPECT_EQ(terms[3].label, "not mid, below");
  EXPECT_EQ(terms[3].points, (std::vector<double>{0, 0, 2, 5}));
  EXPECT_EQ(terms[4].points, (std::vector<double>{5, 8, 10, 10}));
  EXPECT_FALSE(fires(from, {5, 0}));
}

TEST(ImportedRules, NotOfAVerticalEdgeIsZeroAtTheEdge) {
  const auto from = imported(fll("  rule: if x is not box then y is small\n", "  term: box Rectangle 4 6\n"), "a.fll");
  EXPECT_FALSE(fires(from, {4, 0}));
  EXPECT_FALSE(fires(from, {6, 0}));
  EXPECT_TRUE(fires(from, {std::nextafter(4, 0), 0}));
  EXPECT_TRUE(fires(from, {std::nextafter(6, 10), 0}));
}

TEST(ImportedRules, NotInAConclusionIsSplitToo) {
  // NOT of [1, 3] over [0, 8] without its slopes' middle: below from 0, above to 8; fully fired, heights 1 - triangle.
  const auto from = imported(fll("  rule: if x is low then y is not small\n"), "a.fll");
  // Area: 8 minus the triangle's 1; moment: 32 minus 2.
  EXPECT_NEAR(force(from, {0, 0}), 30.0 / 7, 1e-13);
}

TEST(ImportedRules, ANotThatIsNeverTrueDropsItsRule) {
  const auto from = imported(fll("  rule: if x is not whole then y is small\n  rule: if x is low then y is large\n",
                                 "  term: whole Rectangle -1 11\n"),
                             "a.fll");
  ASSERT_TRUE(from.model) << from.refusal;
  EXPECT_EQ(from.model->experts.front().rules.size(), 1U);
}

TEST(ImportedRules, TheSameRuleTwiceCountsWithItsLargerWeight) {
  const auto from = imported(fll("  rule: if x is low then y is small with 0.25\n"
                                 "  rule: if x is low or x is high then y is small with 0.5\n"
                                 "  rule: if x is low then y is large\n"),
                             "a.fll");
  ASSERT_TRUE(from.model) << from.refusal;
  EXPECT_EQ(from.model->experts.front().rules.size(), 3U);
  EXPECT_NEAR(force(from, {0, 0}), (2 * 0.5 + 6) / 1.5, 1e-14);
}

TEST(ImportedRules, WhatCannotBeSplitIsRefused) {
  const auto refused = [](const std::string& rule, const std::string& norms = {}) {
    return imported(fll("  rule: " + rule + "\n", "  term: bell Gaussian 5 1\n", norms), "a.fll").refusal;
  };
  EXPECT_EQ(
      refused("if x is not bell then y is small"),
      "a.fll: line 29, column 12: found NOT of the Gaussian 'bell', wanted NOT of a trapezoid or triangle, which two "
      "terms can carry");
  EXPECT_EQ(refused("if x is low and x is high then y is small"),
            "a.fll: line 29, column 25: found two conditions on 'x' joined by AND, wanted one condition on each input: "
            "Tactus has no term that is the minimum of two");
  EXPECT_EQ(refused("if x is low or z is low then y is small", "  disjunction: AlgebraicSum\n  implication: Minimum\n"),
            "a.fll: line 25, column 16: found the disjunction 'AlgebraicSum', wanted Maximum, all that Tactus has");
  EXPECT_EQ(refused("if x is low and z is low then y is small", "  conjunction: none\n  implication: Minimum\n"),
            "a.fll: line 25, column 16: found no conjunction, wanted Minimum, all that Tactus has");
  std::string many = "if ";
  for (int i = 0; i < 9; ++i) many += std::string(i > 0 ? " and " : "") + "(x is low or z is low)";
  EXPECT_NE(refused(many + " then y is small").find("found a condition of 512 alternatives, wanted at most 256"),
            std::string::npos);
  EXPECT_NE(refused("if " + std::string(40, '(') + "x is low" + std::string(40, ')') + " then y is small")
                .find("found groups nested deeper than 32"),
            std::string::npos);
}

}  // namespace
}  // namespace tactus::exchange
