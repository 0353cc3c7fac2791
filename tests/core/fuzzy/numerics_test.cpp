// Numbers at their limits: tiny strengths, edges a few ulps apart, odd universes, inputs that are no numbers. Every way
// to evaluate must hold the same policies. docs/numerics.md says what is promised.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/analysis/centroid_bound.h"
#include "core/base/random.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/scene.h"

#include "tests/reference/exact_model.h"
#include "tests/stress/agreement.h"
#include "tests/stress/hard_model.h"
#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::fuzzy {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using Point = std::vector<double>;

struct Way {
  std::string name;
  Evaluation force;
};

/// The force at one point by every entry point; in scenes the first `n` inputs are fixed, for every n that leaves the
/// fixed ones finite.
std::vector<Way> everyWay(const ForceModel& model, const Point& point) {
  const auto compiled = compile(model);
  EXPECT_TRUE(compiled.has_value()) << compiled.error().message();
  std::vector<Way> ways = {{"evaluate", compiled->evaluate(point)}};
  if (compiled->expertCount() == 1) ways.push_back({"evaluateExpert", compiled->evaluateExpert(0, point)});

  // The same point thirteen times: more than any vector is wide, and no multiple of it.
  constexpr std::size_t kCopies = 13;
  std::vector<double> force_n(kCopies);
  std::vector<std::uint8_t> fired(kCopies);
  std::vector<std::vector<double>> columns;
  for (const double x : point) columns.emplace_back(kCopies, x);
  const std::vector<std::span<const double>> views(columns.begin(), columns.end());
  const auto add_batch = [&](const std::string& name) {
    for (std::size_t i : {std::size_t{0}, kCopies - 1}) ways.push_back({name, {force_n[i], fired[i] != 0}});
  };
  evaluateBatch(*compiled, views, {force_n, fired});
  add_batch("evaluateBatch");

  std::vector<std::optional<double>> fixed(point.size());
  for (std::size_t n = 0; n <= point.size(); ++n) {
    if (n > 0 && !std::isfinite(point[n - 1])) break;
    if (n > 0) fixed[n - 1] = point[n - 1];
    const auto scene = Scene::specialize(*compiled, fixed);
    EXPECT_TRUE(scene.has_value());
    const std::string name = "scene with " + std::to_string(n) + " fixed";
    ways.push_back({name, scene->evaluate(std::span(point).subspan(n))});
    scene->evaluateBatch(std::span(views).subspan(n), {force_n, fired});
    add_batch(name + ", batch");
  }
  return ways;
}

void expectForce(const ForceModel& model, const Point& point, double wanted_n, double tolerance_n) {
  for (const auto& way : everyWay(model, point)) {
    EXPECT_TRUE(way.force.fired) << way.name;
    EXPECT_NEAR(way.force.force_n, wanted_n, tolerance_n) << way.name;
  }
}

/// One input x on [0, 1] with the term `all`, one rule to each output term, with its weight.
ForceModel modelOf(double min, double max, const std::vector<std::vector<double>>& terms,
                   const std::vector<double>& weights) {
  ForceModel model;
  model.name = "numerics";
  model.inputs = {{"x", "x", "1", 0, 1, {{"all", "all", Shape::kTrapezoid, {0, 0, 1, 1}}}}};
  model.output = {"y", "y", "1", min, max, {}};
  model.experts = {{"E", "E", 1, {}, {}}};
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const std::string id = "t" + std::to_string(t);
    model.output.terms.push_back({id, id, Shape::kTrapezoid, terms[t]});
    model.experts[0].rules.push_back({{{"x", "all"}}, id, weights[t], true});
  }
  return model;
}

// Blocks [0, 1] at three times the height of [1, 2]: (3 * 0.5 + 1.5) / 4, whatever the unit of the heights.
TEST(Numerics, StrengthsDownTo1e300KeepTheirProportions) {
  for (const double unit : {1e-1, 1e-20, 1e-100, 1e-200, 1e-300}) {
    for (const auto implication : {Implication::kClip, Implication::kScale}) {
      ForceModel model = modelOf(0, 2, {{0, 0, 1, 1}, {1, 1, 2, 2}}, {3 * unit, unit});
      model.implication = implication;
      // 3e-300 is itself rounded; that moves the ratio by an ulp.
      expectForce(model, {0.5}, 0.75, 4e-16);
    }
  }
}

// x lies 1e-300 up a ramp; the second rule is half as strong.
TEST(Numerics, AMembershipOf1em300KeepsItsProportion) {
  ForceModel model = modelOf(0, 2, {{0, 0, 1, 1}, {1, 1, 2, 2}}, {1, 1});
  model.inputs[0].terms = {{"all", "all", Shape::kTrapezoid, {0, 1, 1, 1}},
                           {"half", "half", Shape::kTriangle, {0, 1, 2}}};
  model.experts[0].rules[1].weight = 0.5;
  expectForce(model, {1e-300}, (0.5 + 0.5 * 1.5) / 1.5, 4e-16);
}

TEST(Numerics, ASetAFewUlpsWideHasItsCentroidInside) {
  for (const double at : {0.1, 0.7, 1.0}) {
    double end = at;
    for (int ulps = 1; ulps <= 4; ++ulps) {
      end = std::nextafter(end, kInfinity);
      const double low = at, high = end;
      for (const auto& way : everyWay(modelOf(0, 2, {{low, low, high, high}}, {1}), {0.5})) {
        EXPECT_TRUE(way.force.force_n >= low && way.force.force_n <= high) << way.name << ' ' << at << ' ' << ulps;
      }
    }
  }
}

// By hand: the ramp [0, 2] up to 1/2 at 1 and the plateau [1, 3]: area 1.25, moment 2/3 * .25 + 2. Everything grows
// with the unit of the universe.
TEST(Numerics, UniversesOf1em7And1e6) {
  for (const double unit : {1e-7 / 3, 1.0, 1e6 / 3}) {
    const ForceModel model = modelOf(0, 3 * unit, {{0, 2 * unit, 2 * unit, 4 * unit}}, {0.5});
    expectForce(model, {0.5}, (0.25 * 2 / 3 + 2) / 1.25 * unit, 4e-16 * 3 * unit);
  }
  // Far from 0 the same shape; an ulp is 1.2e-10 there.
  expectForce(modelOf(1e6, 1e6 + 3, {{1e6, 1e6 + 2, 1e6 + 2, 1e6 + 4}}, {0.5}), {0.5}, 1e6 + (0.25 * 2 / 3 + 2) / 1.25,
              1.2e-10);
}

// A falling line, a rising line and a plateau meet at (1, 1/2); the outer two are the maximum, and it is symmetric.
TEST(Numerics, ThreeLinesThroughOnePoint) {
  expectForce(modelOf(0, 2, {{0, 0, 0, 2}, {0, 2, 2, 2}, {0, 0, 2, 2}}, {1, 1, 0.5}), {0.5}, 1, 4e-16);
  // Three lines of different slopes through (1, 1/2), against exact arithmetic.
  const ForceModel model = modelOf(0, 2, {{0, 0, 0.5, 1.5}, {0.75, 1.25, 2, 2}, {0, 2, 2, 2}}, {1, 1, 1});
  expectForce(model, {0.5}, reference::exactForce(model, {0.5})->get_d(), 4e-16);
}

TEST(Numerics, ACrispEdgeBelongsToItsTerm) {
  ForceModel model = modelOf(0, 2, {{0, 0, 1, 1}, {1, 1, 2, 2}}, {1, 1});
  model.default_force_n = -1;
  model.inputs[0].terms = {{"all", "all", Shape::kTrapezoid, {0.25, 0.25, 0.5, 0.5}},
                           {"upper", "upper", Shape::kTrapezoid, {0.5, 0.5, 0.75, 0.75}}};
  model.experts[0].rules[1].conditions[0].term = "upper";
  expectForce(model, {0.25}, 0.5, 0);
  expectForce(model, {std::nextafter(0.5, 0)}, 0.5, 0);
  expectForce(model, {0.5}, 1, 2.3e-16);  // both
  expectForce(model, {std::nextafter(0.5, 1)}, 1.5, 0);
  for (const double x : {std::nextafter(0.25, 0), std::nextafter(0.75, 1)}) {
    for (const auto& way : everyWay(model, {x})) {
      EXPECT_FALSE(way.force.fired) << way.name;
      EXPECT_EQ(way.force.force_n, -1) << way.name;
    }
  }
}

// The set lies between two of the thousand samples, which therefore see nothing.
TEST(Numerics, ANarrowOutputTermThatASampledCentroidMisses) {
  const double low = 0.31410, high = 0.31415;
  const ForceModel model = modelOf(0, 1, {{low, low, high, high}, {0.6, 0.6, 0.7, 0.7}}, {1, 0});
  expectForce(model, {0.5}, (low + high) / 2, 1.2e-16);
  const auto compiled = compile(model);
  for (const auto rule : {analysis::Sampling::Rule::kMidpoint, analysis::Sampling::Rule::kLinspace}) {
    const auto sampled = analysis::evaluateSampled(*compiled, Point{0.5}, {rule, 1000});
    EXPECT_TRUE(sampled.fired);
    EXPECT_TRUE(std::isnan(sampled.force_n));
  }
}

TEST(Numerics, AnInputThatIsNoNumberGivesNanEverywhere) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (std::size_t input = 0; input < 4; ++input) {
      Point point = {1, 60, 30, 50};
      point[input] = bad;
      for (const auto& way : everyWay(support::s4AsPrinted(), point)) {
        EXPECT_FALSE(way.force.fired) << way.name;
        EXPECT_TRUE(std::isnan(way.force.force_n)) << way.name;
      }
    }
  }
}

TEST(Numerics, InputsOutsideTheirUniverseAreClampedEverywhere) {
  const ForceModel model = support::s4AsPrinted();
  const auto inside = everyWay(model, {1, 90, 600, 0});
  const auto outside = everyWay(model, {7, 1e300, 601, -3});
  ASSERT_EQ(inside.size(), outside.size());
  for (std::size_t i = 0; i < inside.size(); ++i) {
    EXPECT_TRUE(outside[i].force.fired) << outside[i].name;
    EXPECT_EQ(inside[i].force.force_n, outside[i].force.force_n) << outside[i].name;
  }
}

TEST(Numerics, WhereNothingFiresEveryWayGivesTheDefaultForce) {
  ForceModel model = support::s4AsPrinted();
  model.default_force_n = 0.25;
  for (const auto& way : everyWay(model, {1, 60, 130, 50})) {
    EXPECT_FALSE(way.force.fired) << way.name;
    EXPECT_EQ(way.force.force_n, 0.25) << way.name;
  }
}

// The reference is the definition in long double, whose exponents hold the products and the sum.
TEST(Numerics, OnlyTheRatiosOfTheWeightsCountHoweverFarApartTheyAre) {
  base::Random random(44);
  int several = 0;
  for (int m = 0; m < 600; ++m) {
    ForceModel model = support::randomModel(random, {.gaussians = false, .adversarial = false});
    support::takeExtremeWeights(random, model);
    const auto compiled = compile(model);
    ASSERT_TRUE(compiled);
    for (int p = 0; p < 5; ++p) {
      Point point = support::randomPoint(random, model);
      for (std::size_t i = 0; i < point.size(); ++i) point[i] = compiled->clampInput(i, point[i]);
      long double sum = 0;
      long double weights = 0;
      int fired = 0;
      for (std::size_t e = 0; e < model.experts.size(); ++e) {
        EXPECT_EQ(compiled->weight(e), model.experts[e].weight);
        const auto alone = compiled->evaluateExpert(e, point);
        if (!alone.fired) continue;
        ++fired;
        sum += static_cast<long double>(model.experts[e].weight) * alone.force_n;
        weights += model.experts[e].weight;
      }
      if (fired == 0) continue;
      several += fired > 1 ? 1 : 0;
      SCOPED_TRACE("model " + std::to_string(m));
      expectForce(model, point, static_cast<double>(sum / weights), 1e-12 * (model.output.max - model.output.min));
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(several, 500);
}

TEST(Numerics, WeightsAreNormalizedByAPowerOfTwo) {
  EXPECT_EQ(normalizedWeights(std::vector{1.0, 3.0, 0.0}), (std::vector{0.5, 1.5, 0.0}));
  EXPECT_EQ(normalizedWeights(std::vector{5e-324, 1.5e-323}), (std::vector{0.5, 1.5}));
  // 1e308 lies in [2^1023, 2^1024); the two small ones keep their ratio, 72 bits below.
  const auto far = normalizedWeights(std::vector{5e-324, 0x1p1023, 1.5e-323});
  EXPECT_EQ(far, (std::vector{0x1p-73, 1.0, 0x3p-73}));
  EXPECT_TRUE(normalizedWeights(std::vector<double>{}).empty());
}

void expectAgreement(const ForceModel& model, base::Random& random, int number) {
  const auto found = stress::checkBuildment(model, random, 3);
  ASSERT_FALSE(found.disagreement.has_value()) << "model " << number << ": " << *found.disagreement;
}

TEST(Numerics, EveryWayIsExactOnRandomModels) {
  base::Random random(41);
  for (int m = 0; m < 1000; ++m) {
    expectAgreement(support::randomModel(random, {.gaussians = false, .adversarial = m % 2 == 0}), random, m);
    if (HasFatalFailure()) return;
  }
}

TEST(Numerics, EveryWayIsExactOnHardModels) {
  base::Random random(42);
  for (int m = 0; m < 1000; ++m) {
    expectAgreement(stress::hardModel(random), random, m);
    if (HasFatalFailure()) return;
  }
}

// Ordinary models leave no room for a tolerance of the range: batch and scene follow one point to 4 ulp.
TEST(Numerics, BatchAndSceneAgreeWithOnePointTo4UlpOnOrdinaryModels) {
  base::Random random(43);
  for (int m = 0; m < 1000; ++m) {
    const auto model = support::randomModel(random, {.gaussians = false, .adversarial = false});
    ASSERT_LE(stress::checkBuildment(model, random, 3).largest_ulps, 4) << "model " << m;
  }
}

}  // namespace
}  // namespace tactus::fuzzy
