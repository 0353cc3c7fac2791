#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "core/fuzzy/compiled_model.h"

#include "tests/support/ngt_model.h"

namespace tactus::fuzzy {
namespace {

struct Row {
  std::vector<double> in;  // lubrication, neck flexion, depth, speed
  double clip, scale;
};

void expectRows(ForceModel model, const std::vector<Row>& rows) {
  for (const auto implication : {Implication::kClip, Implication::kScale}) {
    model.implication = implication;
    const auto compiled = compile(model);
    ASSERT_TRUE(compiled.has_value());
    for (const auto& row : rows) {
      const auto force = compiled->evaluate(row.in);
      EXPECT_TRUE(force.fired);
      // The published rows have six digits.
      EXPECT_NEAR(force.force_n, implication == Implication::kClip ? row.clip : row.scale, 0.5e-6)
          << row.in[0] << ' ' << row.in[1] << ' ' << row.in[2] << ' ' << row.in[3];
    }
  }
}

// The same rules over the same terms, listed in another order: the same force, with neighbors who share what is
// shared.
TEST(Evaluate, NamesMeanTheTermsOfTheExpertsOwnLists) {
  ForceModel model = support::s4FiveRegions();
  const auto alone = compile(model);
  for (int e = 1; e <= 3; ++e) {
    model.experts.push_back(model.experts[0]);
    model.experts.back().id = "S" + std::to_string(4 + e);
  }
  for (const Variable* variable : {&model.inputs[0], &model.inputs[2], &model.output}) {
    std::vector<Term> terms(variable->terms.rbegin(), variable->terms.rend());
    model.experts[2].overrides.push_back({variable->id, terms});
  }
  std::reverse(model.experts[3].rules.begin(), model.experts[3].rules.end());
  const auto together = compile(model);
  ASSERT_TRUE(together.has_value());
  const double points[][4] = {{1, 45, 30, 30}, {.3, 45, 70, 80}, {.7, 65, 440, 140}, {.5, 20, 150, 200}};
  for (const auto& point : points) {
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      const auto force = together->evaluateExpert(e, point);
      EXPECT_TRUE(force.fired);
      // Alone and in a team are different entry points: 4 ulp of a force below 1 N.
      EXPECT_NEAR(force.force_n, alone->evaluate(point).force_n, 4 * 0x1p-53) << e;
    }
  }
}

// Three independent programs agree on these rows: Table A2 as printed with the default membership functions.
TEST(Evaluate, S4AsPrintedGivesTheKnownForces) {
  expectRows(support::s4AsPrinted(), {
                                         {{1, 45, 30, 30}, 0.126667, 0.126667},
                                         {{0, 0, 200, 200}, 0.767333, 0.787879},
                                         {{1, 90, 95, 30}, 0.450000, 0.450000},
                                         {{.7, 65, 440, 140}, 0.550000, 0.552500},
                                         {{.3, 45, 170, 80}, 0.645376, 0.654838},
                                         {{1, 0, 500, 50}, 0.224510, 0.224510},
                                         {{.5, 20, 300, 110}, 0.601282, 0.606473},
                                         {{.25, 60, 70, 64}, 0.567284, 0.570909},
                                         {{1, 60, 600, 50}, 0.256573, 0.243231},
                                     });
}

void expectDepths(const ForceModel& model, const std::vector<std::pair<double, double>>& rows) {
  const auto compiled = compile(model);
  ASSERT_TRUE(compiled.has_value());
  for (const auto& [depth_mm, force_n] : rows) {
    const auto force = compiled->evaluate(std::vector<double>{1, 60, depth_mm, 50});
    EXPECT_EQ(force.fired, !std::isnan(force_n)) << depth_mm;
    if (force.fired) {
      EXPECT_NEAR(force.force_n, force_n, 0.5e-5) << depth_mm;
    }
  }
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(Evaluate, ForceOverDepthOfS4AsPrinted) {
  expectDepths(support::s4AsPrinted(),
               {{0, .12667},   {60, .12667},  {70, .33765},  {80, .45},     {120, .45},    {125, kNone},  {130, kNone},
                {137, kNone},  {139, .5},     {145, .49428}, {150, .47875}, {160, .46882}, {170, .46797}, {185, .46797},
                {200, .58944}, {215, .54365}, {420, .54365}, {440, .46445}, {460, .25657}, {600, .25657}});
}

TEST(Evaluate, ForceOverDepthOfS4Shifted) {
  expectDepths(support::s4Shifted(), {{110, .47130},
                                      {115, .47875},
                                      {125, .46797},
                                      {137, .46797},
                                      {150, .58944},
                                      {160, .54761},
                                      {185, .54365},
                                      {200, .46445},
                                      {215, .25657},
                                      {420, .25657},
                                      {440, .29855},
                                      {460, kNone},
                                      {600, kNone}});
}

TEST(Evaluate, ForceOverDepthOfS4WithFiveRegionsHasNoHole) {
  expectDepths(support::s4FiveRegions(), {{125, .46797}, {150, .46797}, {185, .46797}, {200, .58944}});
  const auto compiled = compile(support::s4FiveRegions());
  for (double depth_mm = 0; depth_mm <= 600; depth_mm += 0.25) {
    EXPECT_TRUE(compiled->evaluate(std::vector<double>{1, 60, depth_mm, 50}).fired) << depth_mm;
  }
}

TEST(Evaluate, InputsOutsideTheirUniverseAreClamped) {
  const auto compiled = compile(support::s4AsPrinted());
  const auto inside = compiled->evaluate(std::vector<double>{1, 90, 600, 0});
  const auto outside = compiled->evaluate(std::vector<double>{7, 1e300, 601, -3});
  EXPECT_EQ(inside.force_n, outside.force_n);
}

TEST(Evaluate, AnInputThatIsNoNumberGivesNoForce) {
  const auto compiled = compile(support::s4AsPrinted());
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    const auto force = compiled->evaluate(std::vector<double>{1, 60, bad, 50});
    EXPECT_FALSE(force.fired);
    EXPECT_TRUE(std::isnan(force.force_n));
  }
}

TEST(Evaluate, WhereNothingFiresTheDefaultForceComesOut) {
  ForceModel model = support::s4AsPrinted();
  model.default_force_n = 0.25;
  const auto force = compile(model)->evaluate(std::vector<double>{1, 60, 130, 50});
  EXPECT_FALSE(force.fired);
  EXPECT_EQ(force.force_n, 0.25);
}

/// Two experts who name one output term each: A says y is low (centroid 1), B says y is high (centroid 3), B only for x
/// >= 5.
ForceModel twoExperts(double weight_a, double weight_b) {
  ForceModel model;
  model.inputs = {
      {"x",
       "x",
       "1",
       0,
       10,
       {{"all", "all", Shape::kTrapezoid, {0, 0, 10, 10}}, {"upper", "upper", Shape::kTrapezoid, {5, 5, 10, 10}}}}};
  model.output = {
      "y", "y", "1",
      0,   4,   {{"low", "low", Shape::kTrapezoid, {0, 0, 2, 2}}, {"high", "high", Shape::kTrapezoid, {2, 2, 4, 4}}}};
  model.experts = {{"A", "A", weight_a, {}, {{{{"x", "all"}}, "low"}}},
                   {"B", "B", weight_b, {}, {{{{"x", "upper"}}, "high"}}}};
  return model;
}

TEST(Evaluate, ExpertsWhoAbstainDoNotCount) {
  const auto compiled = compile(twoExperts(1, 1));
  EXPECT_DOUBLE_EQ(compiled->evaluate(std::vector<double>{4}).force_n, 1);
  EXPECT_DOUBLE_EQ(compiled->evaluate(std::vector<double>{5}).force_n, 2);  // the vertical edge belongs to the term
  EXPECT_FALSE(compiled->evaluateExpert(1, std::vector<double>{4}).fired);
  EXPECT_DOUBLE_EQ(compiled->evaluateExpert(1, std::vector<double>{6}).force_n, 3);
}

TEST(Evaluate, WeightsAreRelative) {
  EXPECT_DOUBLE_EQ(compile(twoExperts(1, 3))->evaluate(std::vector<double>{6}).force_n, 2.5);
  EXPECT_DOUBLE_EQ(compile(twoExperts(1e-200, 3e-200))->evaluate(std::vector<double>{6}).force_n, 2.5);
}

TEST(Evaluate, AnExpertOfWeightZeroIsAbsentFromTheMean) {
  const auto compiled = compile(twoExperts(0, 1));
  EXPECT_FALSE(compiled->evaluate(std::vector<double>{4}).fired);
  EXPECT_DOUBLE_EQ(compiled->evaluate(std::vector<double>{6}).force_n, 3);
}

TEST(Evaluate, DisabledRulesAndRulesOfWeightZeroDoNotFire) {
  ForceModel model = twoExperts(1, 0);
  model.experts[0].rules[0].enabled = false;
  EXPECT_FALSE(compile(model)->evaluate(std::vector<double>{6}).fired);
  model.experts[0].rules[0] = {{{"x", "all"}}, "low", 0, true};
  EXPECT_FALSE(compile(model)->evaluate(std::vector<double>{6}).fired);
}

TEST(Evaluate, AnExpertsOwnTermsReplaceTheSharedOnes) {
  ForceModel model = twoExperts(1, 1);
  model.experts[0].overrides = {{"y", {{"low", "low", Shape::kTriangle, {3, 3.5, 4}}}}};
  EXPECT_DOUBLE_EQ(compile(model)->evaluateExpert(0, std::vector<double>{4}).force_n, 3.5);
  EXPECT_DOUBLE_EQ(compile(model)->evaluateExpert(1, std::vector<double>{6}).force_n, 3);
}

TEST(Evaluate, ARuleWhoseStrengthUnderflowsStillFires) {
  ForceModel model = twoExperts(1, 0);
  model.inputs[0].terms[0].points = {0, 1e150, 1e150, 1e150};
  model.experts[0].rules[0].weight = 1e-300;
  const auto force = compile(model)->evaluate(std::vector<double>{1e-100});
  EXPECT_TRUE(force.fired);
  EXPECT_DOUBLE_EQ(force.force_n, 1);
}

}  // namespace
}  // namespace tactus::fuzzy
