// Gradients by hand, and those of Gaussian models against differences.
#include "core/analysis/gradient/gradient.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/support/random_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;
using fuzzy::Implication;
using fuzzy::Shape;

fuzzy::Term term(const std::string& id, std::vector<double> points) {
  const Shape shape = points.size() == 4 ? Shape::kTrapezoid : points.size() == 3 ? Shape::kTriangle : Shape::kGaussian;
  return {id, id, shape, std::move(points)};
}

/// One input x in [0, 1] with `rising` (membership x) and `always` (1), an output on [0, 1] with the rectangles `low`
/// (0 to .2) and `high` (.6 to 1), rules rising -> low and always -> high.
/// At x: area .2 x + .4, at x = .5 the centroid is (.1 * .1 + .4 * .8) / .5 = .66.
ForceModel twoRectangles() {
  ForceModel model;
  model.name = "two rectangles";
  model.created_utc = "2026-01-01T00:00:00Z";
  model.generator = "test";
  model.default_force_n = 0.3;
  model.inputs = {{"x", "x", "1", 0, 1, {term("rising", {0, 1, 1, 1}), term("always", {0, 0, 1, 1})}}};
  model.output = {"y", "y", "N", 0, 1, {term("low", {0, 0, .2, .2}), term("high", {.6, .6, 1, 1})}};
  model.experts = {{"E", "E", 1, {}, {{{{"x", "rising"}}, "low"}, {{{"x", "always"}}, "high"}}}};
  return model;
}

struct Evaluated {
  GradientModel model;
  Gradient gradient;

  Evaluated(const ForceModel& force_model, const std::vector<double>& point)
      : model(GradientModel::of(force_model).value()), gradient(model.makeGradient()) {
    model.evaluate(point, gradient);
  }
  double input(std::size_t i) const { return gradient[model.inputSlot(i)]; }
  double point(std::size_t variable, std::size_t term, std::size_t p) const {
    return gradient[model.pointSlot(variable, term, p)];
  }
  double weight(std::size_t expert, std::size_t rule) const { return gradient[model.weightSlot(expert, rule)]; }
};

// Sums and quotients of a few numbers below 1.
constexpr double kRounding = 1e-15;

TEST(Gradient, FromTheCentroidBackToWeightVertexAndInput) {
  // dF/ds = .2 (.1 - .66) / .5 = -.224 for the strength s = x = .5 of `low`.
  const Evaluated at(twoRectangles(), {.5});
  EXPECT_TRUE(at.gradient.fired);
  EXPECT_NEAR(at.gradient.force_n, .66, kRounding);
  EXPECT_NEAR(at.input(0), -.224, kRounding);
  EXPECT_NEAR(at.weight(0, 0), -.224 * .5, kRounding);
  EXPECT_NEAR(at.point(0, 0, 0), .224 * .5, kRounding);  // d(membership)/da = -(b - x) / (b - a)^2
  EXPECT_NEAR(at.point(0, 0, 1), .224 * .5, kRounding);  // d(membership)/db = -(x - a) / (b - a)^2
  EXPECT_EQ(at.point(0, 1, 0), 0);
  // And dF/ds = .4 (.8 - .66) / .5 = .112 for `high`, of strength 1.
  EXPECT_NEAR(at.weight(0, 1), .112, kRounding);
}

TEST(Gradient, VerticalEdgesMoveWhereTheyCan) {
  // `high` has strength 1 and its edge at .6 is .06 below the centroid. Moved out, a adds half the height times the
  // step; moved in, b takes as much away: dF = -+ (1/2) (.6 - .66) / .5. Its other edge is the border.
  for (const auto implication : {Implication::kClip, Implication::kScale}) {
    ForceModel model = twoRectangles();
    model.implication = implication;
    const Evaluated at(model, {.5});
    EXPECT_NEAR(at.point(1, 1, 0), .06, kRounding);
    EXPECT_NEAR(at.point(1, 1, 1), .06, kRounding);
    EXPECT_NEAR(at.point(1, 1, 2), .34, kRounding);
    EXPECT_EQ(at.point(1, 1, 3), 0);
    // `low` has strength .5, its edge at .2 is .46 below. Clipped, the ramp that d makes rises past .5 at half its
    // width and has area .5 - .125; that of c loses .125. Scaled, both are .25.
    const double clip = implication == Implication::kClip ? 1 : 0;
    EXPECT_NEAR(at.point(1, 0, 3), (.25 + .125 * clip) * -.46 / .5, kRounding);
    EXPECT_NEAR(at.point(1, 0, 2), (.25 - .125 * clip) * -.46 / .5, kRounding);
    EXPECT_EQ(at.point(1, 0, 0), 0);
  }
}

TEST(Gradient, AVerticalEdgeUnderAnotherSetDoesNothing) {
  // `low` reaches into a higher `high`: its edge at .7 is covered, that of `high` at .6 stands on height .5. With area
  // .5 * .6 + .4 and moment .3 * .3 + .4 * .8 the centroid is .41 / .7.
  ForceModel model = twoRectangles();
  model.output.terms[0].points = {0, 0, .7, .7};
  const Evaluated at(model, {.5});
  const double to_edge = .6 - .41 / .7;
  EXPECT_EQ(at.point(1, 0, 3), 0);
  EXPECT_EQ(at.point(1, 0, 2), 0);
  // The ramp shows between the heights .5 and 1, where 1 - membership is .25 on average and membership .75.
  EXPECT_NEAR(at.point(1, 1, 0), -.5 * .25 * to_edge / .7, kRounding);
  EXPECT_NEAR(at.point(1, 1, 1), -.5 * .75 * to_edge / .7, kRounding);
}

TEST(Gradient, KinksTakeThePieceToTheRight) {
  ForceModel model = twoRectangles();
  model.inputs[0].terms[0].points = {0, .5, .5, 1};
  // Membership 1: dF/ds = .2 (.1 - F) / .6 with F = (.02 + .32) / .6. To the right it falls at the rate 2.
  const double by_strength = .2 * (.1 - .34 / .6) / .6;
  const Evaluated at(model, {.5});
  EXPECT_NEAR(at.input(0), -2 * by_strength, kRounding);
  EXPECT_EQ(at.point(0, 0, 1), 0);
  EXPECT_NEAR(at.point(0, 0, 2), 2 * by_strength, kRounding);
  EXPECT_EQ(at.point(0, 0, 3), 0);
  EXPECT_EQ(Evaluated(model, {0}).input(0), 0) << "a rule of strength 0 counts as absent";
}

TEST(Gradient, AtTheUpperEndOfTheUniverseThePieceToTheLeft) {
  const double by_strength = .2 * (.1 - .34 / .6) / .6;
  EXPECT_NEAR(Evaluated(twoRectangles(), {1}).input(0), by_strength, kRounding);
  const Evaluated outside(twoRectangles(), {1.5});
  EXPECT_EQ(outside.input(0), 0);
  EXPECT_NEAR(outside.point(0, 0, 1), -by_strength, kRounding) << "the terms feel the clamped input";
}

TEST(Gradient, TiesGoToTheFirst) {
  ForceModel model = twoRectangles();
  model.inputs.push_back(model.inputs[0]);
  model.inputs[1].id = "z";
  auto& rules = model.experts[0].rules;
  rules[0].conditions = {{"z", "rising"}, {"x", "rising"}};
  rules.push_back({{{"x", "rising"}}, "low"});
  const Evaluated at(model, {.5, .5});
  EXPECT_EQ(at.input(0), 0);
  EXPECT_NEAR(at.input(1), -.224, kRounding);
  EXPECT_NEAR(at.weight(0, 0), -.112, kRounding);
  EXPECT_EQ(at.weight(0, 2), 0);
}

TEST(Gradient, WeightedExpertsAndThoseThatAbstain) {
  ForceModel model = twoRectangles();
  auto second = model.experts[0];
  second.id = "second";
  second.weight = 3;
  second.overrides = {{"x", {term("rising", {.4, .9, 1, 1}), term("always", {0, 0, 1, 1})}}};
  auto silent = model.experts[0];
  silent.id = "silent";
  silent.weight = 7;
  silent.rules = {{{{"x", "rising"}}, "low", 0}};
  auto absent = model.experts[0];
  absent.id = "absent";
  absent.weight = 0;
  model.experts.insert(model.experts.end(), {second, silent, absent});
  const Evaluated at(model, {.5});
  EXPECT_TRUE(at.model.hasOwnTerms(1, 0));
  EXPECT_FALSE(at.model.hasOwnTerms(1, 1));
  EXPECT_NE(at.model.pointSlot(1, 0, 0, 1), at.model.pointSlot(0, 0, 1));
  // The second expert's strength is (.5 - .4) / .5 = .2: area .44, F = (.004 + .32) / .44, dF/ds = .2 (.1 - F) / .44.
  const double second_force = .324 / .44;
  const double second_by_strength = .2 * (.1 - second_force) / .44;
  EXPECT_NEAR(at.gradient.force_n, .25 * .66 + .75 * second_force, kRounding);
  EXPECT_NEAR(at.input(0), .25 * -.224 + .75 * second_by_strength * 2, kRounding);
  EXPECT_NEAR(at.weight(0, 0), .25 * -.112, kRounding);
  EXPECT_NEAR(at.weight(1, 0), .75 * second_by_strength * .2, kRounding);
  EXPECT_NEAR(at.point(0, 0, 1), .25 * .112, kRounding) << "the shared list";
  EXPECT_NEAR(at.gradient[at.model.pointSlot(1, 0, 0, 1)], .75 * second_by_strength * -.4, kRounding);
  EXPECT_EQ(at.weight(2, 0), 0);
  EXPECT_EQ(at.weight(3, 0), 0);
}

TEST(Gradient, WhereNothingFiresTheForceIsConstant) {
  ForceModel model = twoRectangles();
  model.experts[0].rules.pop_back();
  const Evaluated at(model, {0});
  EXPECT_FALSE(at.gradient.fired);
  EXPECT_EQ(at.gradient.force_n, .3);
  for (const double value : at.gradient.values()) EXPECT_EQ(value, 0);
}

TEST(Gradient, InputsThatAreNotNumbersGiveNone) {
  for (const double x : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Evaluated at(twoRectangles(), {x});
    EXPECT_FALSE(at.gradient.fired);
    EXPECT_TRUE(std::isnan(at.gradient.force_n));
    for (const double value : at.gradient.values()) EXPECT_TRUE(std::isnan(value));
  }
}

TEST(Gradient, AModelThatMakesNoSenseIsRefused) {
  ForceModel model = twoRectangles();
  model.experts[0].rules[0].then = "nothing";
  const auto gradients = GradientModel::of(model);
  ASSERT_FALSE(gradients.has_value());
  EXPECT_EQ(gradients.error().place, "/experts/0/rules/0/then");
}

TEST(Gradient, AGaussianOutputTermCarriesTheForceWithItsMean) {
  for (const auto implication : {Implication::kClip, Implication::kScale}) {
    ForceModel model = twoRectangles();
    model.implication = implication;
    model.output.terms[0] = term("low", {.5, .01});  // 50 sigmas from the borders
    model.experts[0].rules.pop_back();
    const Evaluated at(model, {.5});
    EXPECT_NEAR(at.gradient.force_n, .5, 1e-12);
    EXPECT_NEAR(at.point(1, 0, 0), 1, 1e-12);
    EXPECT_NEAR(at.point(1, 0, 1), 0, 1e-12);
    EXPECT_NEAR(at.input(0), 0, 1e-12);
  }
}

/// Where Gaussians and trapezoids overlap: Richardson's extrapolation of central differences of the evaluator. The
/// evaluator is exact to 1e-12 and the step is 1e-3 of values of order 1, so the differences are to about 1e-8.
TEST(Gradient, OverlappingGaussiansAgreeWithDifferencesOfTheEvaluator) {
  for (const auto implication : {Implication::kClip, Implication::kScale}) {
    ForceModel model = twoRectangles();
    model.implication = implication;
    model.inputs[0].terms = {term("bell", {.2, .4}), term("falling", {0, 0, .1, 1.3}), term("wide", {.9, .7})};
    model.output.terms = {term("low", {.25, .2}), term("high", {.75, .15}), term("middle", {.1, .5, .6, 1.05})};
    model.experts[0].rules = {{{{"x", "bell"}}, "low"}, {{{"x", "falling"}}, "high", .8}, {{{"x", "wide"}}, "middle"}};
    const Evaluated at(model, {.45});
    const auto check = [&](double& parameter, double value, const char* what) {
      const double start = parameter;
      const auto difference = [&](double step) {
        parameter = start + step;
        const double above = fuzzy::compile(model)->evaluate(std::vector<double>{.45}).force_n;
        parameter = start - step;
        const double below = fuzzy::compile(model)->evaluate(std::vector<double>{.45}).force_n;
        parameter = start;
        return (above - below) / (2 * step);
      };
      EXPECT_NEAR(value, (4 * difference(5e-4) - difference(1e-3)) / 3, 1e-7) << what;
      EXPECT_NE(value, 0) << what;
    };
    for (std::size_t r = 0; r < 3; ++r) {
      auto& rule = model.experts[0].rules[r];
      if (r == 1) check(rule.weight, at.weight(0, r), "weight");
      auto& in = model.inputs[0].terms[r].points;
      auto& out = model.output.terms[r].points;
      if (r == 1) {
        check(in[2], at.point(0, r, 2), "input c");
        check(in[3], at.point(0, r, 3), "input d");
      } else {
        for (std::size_t p = 0; p < 2; ++p) check(in[p], at.point(0, r, p), "input mean or sigma");
      }
      for (std::size_t p = 0; p < out.size(); ++p) {
        if (at.point(1, r, p) != 0) check(out[p], at.point(1, r, p), "output point");
      }
    }
    const auto along = [&](double x) { return fuzzy::compile(model)->evaluate(std::vector<double>{x}).force_n; };
    const auto slope = [&](double step) { return (along(.45 + step) - along(.45 - step)) / (2 * step); };
    EXPECT_NEAR(at.input(0), (4 * slope(5e-4) - slope(1e-3)) / 3, 1e-7);
  }
}

TEST(Gradient, RandomGaussianModelsGiveTheForceOfTheEvaluator) {
  base::Random random(14);
  for (int m = 0; m < 200; ++m) {
    const ForceModel model = support::randomModel(random, {.gaussians = true, .adversarial = m % 2 == 0});
    const auto point = support::randomPoint(random, model);
    const Evaluated at(model, point);
    const auto force = fuzzy::compile(model)->evaluate(point);
    ASSERT_EQ(at.gradient.fired, force.fired);
    // Each is within 1e-12 of the range and 2 ulp.
    ASSERT_NEAR(at.gradient.force_n, force.force_n,
                2e-12 * (model.output.max - model.output.min) + 9e-16 * std::abs(force.force_n));
    for (const double value : at.gradient.values()) ASSERT_FALSE(std::isnan(value));
  }
}

}  // namespace
}  // namespace tactus::analysis
