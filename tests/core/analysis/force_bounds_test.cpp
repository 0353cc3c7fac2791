
#include <gtest/gtest.h>

#include "core/analysis/lint.h"
#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;
using fuzzy::Shape;

// The ends of an ordered set stand alone, so the bounds are centroids of single terms. Clipped toward strength 0,
// very_large (.7, .8, 1.1, 1.1) is a bar on [.7, 1.1] with centroid .9, at strength 1 it is .323333 / .35 = .923810;
// very_small (0, 0, .2, .3) is .15 toward strength 0 and .0316667 / .25 = .126667 at 1.
TEST(ForceBounds, OfS4AreTheCentroidsOfTheEndTerms) {
  for (const auto implication : {fuzzy::Implication::kClip, fuzzy::Implication::kScale}) {
    ForceModel model = support::s4AsPrinted();
    model.implication = implication;
    const auto bounds = forceBounds(model, 0);
    ASSERT_TRUE(bounds.has_value());
    EXPECT_NEAR(bounds->min_n, 0.19 / 6 / 0.25, 1e-11);
    EXPECT_NEAR(bounds->max_n, 0.97 / 3 / 0.35, 1e-11);
    EXPECT_LT(bounds->min_n, 0.19 / 6 / 0.25);
    EXPECT_GT(bounds->max_n, 0.97 / 3 / 0.35);
  }
}

// With weights of .5 the end terms are cut at .5. very_small becomes (0, .25, .3): area .275 * .5, and its moment over
// .5 is .25 * .125 + .025 * (.25 + .05 / 3) = .0379166667, so the centroid is .0379166667 / .275.
TEST(ForceBounds, KnowTheWeightsOfTheRules) {
  ForceModel model = support::s4AsPrinted();
  for (auto& rule : model.experts[0].rules) rule.weight = .5;
  EXPECT_NEAR(forceBounds(model, 0)->min_n, .03791666666666667 / .275, 1e-11);
}

/// One input x in [0, 1]; at x = 0 `f` alone fires, at x = 1 `g` alone, at .5 both, all fully.
ForceModel twoTerms(std::vector<double> f, std::vector<double> g) {
  ForceModel model;
  model.implication = fuzzy::Implication::kScale;
  model.inputs = {
      {"x",
       "x",
       "1",
       0,
       1,
       {{"low", "low", Shape::kTrapezoid, {0, 0, .6, .6}}, {"high", "high", Shape::kTrapezoid, {.4, .4, 1, 1}}}}};
  model.output = {"y", "y", "N",
                  0,   10,  {{"f", "f", Shape::kTriangle, std::move(f)}, {"g", "g", Shape::kTriangle, std::move(g)}}};
  model.experts = {{"A", "A", 1, {}, {{{{"x", "low"}}, "f"}, {{{"x", "high"}}, "g"}}}};
  return model;
}

// The union of the triangles (0, 5, 10), centroid 5, and (0, 6, 6), centroid 4, has its centroid above both.
TEST(ForceBounds, AUnionMayLieOutsideItsTerms) {
  const ForceModel model = twoTerms({0, 5, 10}, {0, 6, 6});
  const auto compiled = fuzzy::compile(model);
  EXPECT_NEAR(compiled->evaluate(std::vector{0.0}).force_n, 5, 1e-12);
  EXPECT_NEAR(compiled->evaluate(std::vector{1.0}).force_n, 4, 1e-12);
  const double both = compiled->evaluate(std::vector{0.5}).force_n;
  EXPECT_GT(both, 5.005);
  EXPECT_GE(forceBounds(model, 0)->max_n, both);
  EXPECT_LT(forceBounds(model, 0)->max_n, 10);
}

// A bell at .3, 15 sigmas from the nearer border. Scaled, its centroid is .3 whatever the strength. Clipped, it is .3
// at strength 1 and moves to .5, the middle of the universe, as the strength falls and the plateau fills the universe.
TEST(ForceBounds, OfAGaussianAlone) {
  ForceModel model = twoTerms({0, 1, 2}, {0, 1, 2});
  model.output.max = 1;
  model.output.terms[0] = {"f", "f", Shape::kGaussian, {.3, .02}};
  model.experts[0].rules.pop_back();
  EXPECT_NEAR(forceBounds(model, 0)->min_n, .3, 1e-11);
  EXPECT_NEAR(forceBounds(model, 0)->max_n, .3, 1e-11);
  model.implication = fuzzy::Implication::kClip;
  EXPECT_NEAR(forceBounds(model, 0)->min_n, .3, 1e-11);
  EXPECT_NEAR(forceBounds(model, 0)->max_n, .5, 1e-11);
}

// Beside the bell a triangle whose centroid, .8, is the largest there is: the bell only pulls it down.
TEST(ForceBounds, OfAGaussianAndATriangle) {
  ForceModel model = twoTerms({0, 1, 2}, {.7, .8, .9});
  model.output.max = 1;
  model.output.terms[0] = {"f", "f", Shape::kGaussian, {.3, .02}};
  EXPECT_NEAR(forceBounds(model, 0)->min_n, .3, 1e-11);
  EXPECT_NEAR(forceBounds(model, 0)->max_n, .8, 1e-11);
}

TEST(ForceBounds, NothingWhereNoRuleCanFire) {
  ForceModel model = support::s4AsPrinted();
  model.experts[0].rules.clear();
  EXPECT_FALSE(forceBounds(model, 0).has_value());
}

// So narrow that its width is lost when it is seen from the lower end of the universe.
TEST(ForceBounds, KnowTermsOfAFewUlps) {
  ForceModel model = twoTerms({-5e5, 1e5, 8e5}, {474262, 474262, 474262.00000000006});
  model.output.min = -1e6;
  model.output.max = 1e6;
  const auto compiled = fuzzy::compile(model);
  ASSERT_TRUE(compiled.has_value());
  const double alone = compiled->evaluate(std::vector{1.0}).force_n;
  EXPECT_NEAR(alone, 474262, 1e-9);
  EXPECT_LE(alone, forceBounds(model, 0)->max_n);
}

// Two experts that both always fire: the mean cannot come as low as the lower of the two.
TEST(ForceBounds, TheMeanOfExpertsWhoNeverAbstainIsBoundedByTheMean) {
  ForceModel model = twoTerms({0, 1, 2}, {0, 1, 2});
  auto other = model.experts[0];
  other.id = "B";
  other.overrides = {{"y", {{"f", "f", Shape::kTriangle, {4, 5, 6}}, {"g", "g", Shape::kTriangle, {4, 5, 6}}}}};
  model.experts.push_back(other);
  const auto both = forceBounds(model, {true, true});
  EXPECT_GT(both->min_n, 2.5);
  EXPECT_LT(both->max_n, 3.5);
  EXPECT_LT(forceBounds(model, {true, false})->max_n, 3.5);
  EXPECT_LT(forceBounds(model, {false, true})->min_n, 3);
  EXPECT_LT(forceBounds(model, {false, false})->min_n, 1);
  EXPECT_GT(forceBounds(model, {false, false})->max_n, 5);
}

TEST(ForceBounds, EveryFiredForceOfRandomModelsLiesWithin) {
  base::Random random(21);
  for (int m = 0; m < 1000; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    const ForceModel model = support::randomModel(random, {.gaussians = m % 3 == 0, .adversarial = m % 2 == 1});
    const auto compiled = fuzzy::compile(model);
    std::vector<bool> always(model.experts.size());
    for (std::size_t e = 0; e < always.size(); ++e) always[e] = coverage(model, std::span(&e, 1)).holes.empty();
    const auto mean = forceBounds(model, always);
    std::vector<std::optional<ForceBounds>> own;
    for (std::size_t e = 0; e < always.size(); ++e) own.push_back(forceBounds(model, e));
    for (int p = 0; p < 40; ++p) {
      const auto point = support::randomPoint(random, model);
      for (std::size_t e = 0; e < model.experts.size(); ++e) {
        const auto force = compiled->evaluateExpert(e, point);
        if (!force.fired) continue;
        ASSERT_TRUE(own[e].has_value());
        ASSERT_GE(force.force_n, own[e]->min_n);
        ASSERT_LE(force.force_n, own[e]->max_n);
      }
      const auto force = compiled->evaluate(point);
      if (!force.fired) continue;
      ASSERT_TRUE(mean.has_value());
      ASSERT_GE(force.force_n, mean->min_n);
      ASSERT_LE(force.force_n, mean->max_n);
    }
  }
}

}  // namespace
}  // namespace tactus::analysis
