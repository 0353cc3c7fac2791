#include "core/analysis/coverage.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;

std::vector<std::size_t> everyone(const ForceModel& model) {
  std::vector<std::size_t> all(model.experts.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

// Table A2 as printed has no rule for the oropharynx: between the nasopharynx, which ends at 125 mm with membership 0,
// and the laryngopharynx, which begins at 138 mm, nothing fires.
TEST(Coverage, TheOropharynxHoleOfTableA2) {
  const ForceModel model = support::s4AsPrinted();
  const auto found = coverage(model, everyone(model));
  ASSERT_EQ(found.holes.size(), 1);
  EXPECT_TRUE(found.complete);
  EXPECT_EQ(found.holes[0].ranges[2], (InputRange{"depth", 125, 138, true, true, false}));
  EXPECT_TRUE(found.holes[0].ranges[0].whole_universe);
  EXPECT_EQ(describe(found.holes[0], model), "depth 125 to 138 mm");
}

TEST(Coverage, TheShiftedReadingHasItsHoleInTheStomach) {
  const ForceModel model = support::s4Shifted();
  const auto found = coverage(model, everyone(model));
  ASSERT_EQ(found.holes.size(), 1);
  EXPECT_EQ(found.holes[0].ranges[2], (InputRange{"depth", 460, 600, true, true, false}));
}

TEST(Coverage, FiveRegionsHaveNoHole) {
  const ForceModel model = support::s4FiveRegions();
  EXPECT_TRUE(coverage(model, everyone(model)).holes.empty());
}

TEST(Coverage, AnExpertWithoutRulesAbstainsEverywhere) {
  ForceModel model = support::s4AsPrinted();
  model.experts[0].rules.clear();
  const auto found = coverage(model, everyone(model));
  ASSERT_EQ(found.holes.size(), 1);
  EXPECT_EQ(describe(found.holes[0], model), "everywhere");
}

TEST(Coverage, VerticalEdgesBelongToTheTermAndNotToTheHole) {
  ForceModel model = support::ngtVariables();
  model.inputs = {{"x",
                   "x",
                   "1",
                   0,
                   10,
                   {{"low", "low", fuzzy::Shape::kTrapezoid, {0, 0, 3, 3}},
                    {"high", "high", fuzzy::Shape::kTrapezoid, {7, 7, 10, 10}}}}};
  model.experts = {{"A", "A", 1, {}, {{{{"x", "low"}}, "small"}, {{{"x", "high"}}, "large"}}}};
  const auto found = coverage(model, everyone(model));
  ASSERT_EQ(found.holes.size(), 1);
  EXPECT_EQ(found.holes[0].ranges[0], (InputRange{"x", 3, 7, false, false, false}));
}

bool contains(const Hole& hole, const std::vector<double>& point) {
  for (std::size_t i = 0; i < point.size(); ++i) {
    const auto& r = hole.ranges[i];
    const bool inside = (r.low_included ? point[i] >= r.low : point[i] > r.low) &&
                        (r.high_included ? point[i] <= r.high : point[i] < r.high);
    if (!inside) return false;
  }
  return true;
}

// A point lies in exactly one hole where nothing fires, and in none where something does.
TEST(Coverage, HolesAreExactlyWhereNothingFires) {
  base::Random random(7);
  for (int m = 0; m < 400; ++m) {
    const ForceModel model = support::randomModel(random, {});
    const auto compiled = fuzzy::compile(model);
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      const auto found = coverage(model, std::span(&e, 1));
      ASSERT_TRUE(found.complete);
      for (int p = 0; p < 10; ++p) {
        auto point = support::randomPoint(random, model);
        for (std::size_t i = 0; i < point.size(); ++i) point[i] = compiled->clampInput(i, point[i]);
        int holes = 0;
        for (const auto& hole : found.holes) holes += contains(hole, point) ? 1 : 0;
        ASSERT_EQ(holes, compiled->evaluateExpert(e, point).fired ? 0 : 1) << "model " << m << ", expert " << e;
      }
    }
  }
}

/// One input from 0 to 100 with these Gaussians (mean, sigma), a rule for each.
ForceModel gaussianModel(const std::vector<std::pair<double, double>>& gaussians) {
  ForceModel model = support::ngtVariables();
  model.inputs = {{"x", "x", "1", 0, 100, {}}};
  model.experts = {{"A", "A", 1, {}, {}}};
  for (const auto& [mean, sigma] : gaussians) {
    const std::string id = "t" + std::to_string(model.inputs[0].terms.size());
    model.inputs[0].terms.push_back({id, id, fuzzy::Shape::kGaussian, {mean, sigma}});
    model.experts[0].rules.push_back({{{"x", id}}, "small"});
  }
  return model;
}

TEST(Coverage, NarrowGaussiansEndWhereTheyUnderflow) {
  // exp(-u^2 / 2) is 0 in doubles from u = sqrt(2 * 745.13) = 38.604 on; before, any of these was a hole over
  // everything or none at all.
  auto model = gaussianModel({{20, 0.1}});
  auto found = coverage(model, everyone(model));
  ASSERT_EQ(found.holes.size(), 2);
  EXPECT_EQ(found.holes[0].ranges[0].low, 0);
  EXPECT_NEAR(found.holes[0].ranges[0].high, 20 - 3.8604, 1e-4);
  EXPECT_FALSE(found.holes[0].ranges[0].high_included);
  EXPECT_NEAR(found.holes[1].ranges[0].low, 20 + 3.8604, 1e-4);
  EXPECT_EQ(found.holes[1].ranges[0].high, 100);

  model = gaussianModel({{50, 1}});  // in the middle, where every cell was looked at
  EXPECT_EQ(coverage(model, everyone(model)).holes.size(), 2);
  model = gaussianModel({{0, 1}, {77, 1}});  // together they cover all
  EXPECT_TRUE(coverage(model, everyone(model)).holes.empty());
  model = gaussianModel({{50, 3}});
  EXPECT_TRUE(coverage(model, everyone(model)).holes.empty());
}

TEST(Coverage, AHoleBesideAGaussianHasANameThatCanBeRead) {
  // 20 -+ 38.604 * 0.1 (above); the last digits of the exact ends are not checked.
  const auto model = gaussianModel({{20, 0.1}});
  const auto found = coverage(model, everyone(model));
  ASSERT_EQ(found.holes.size(), 2);
  EXPECT_EQ(describe(found.holes[0], model), "x 0 to 16.1396");
  EXPECT_EQ(describe(found.holes[1], model), "x 23.8604 to 100");
}

TEST(Coverage, TwoHolesNeverHaveOneName) {
  base::Random random(13);
  for (int m = 0; m < 300; ++m) {
    std::vector<std::pair<double, double>> gaussians;
    double mean = random.uniform(0, 5);
    for (int t = 0, count = 2 + random.below(5); t < count; ++t) {
      const double sigma = std::pow(10, random.uniform(-14, -1));
      gaussians.emplace_back(mean, sigma);
      mean += 80 * sigma * random.uniform(0.9, 1.1);  // side by side, some with a gap of a few digits between
    }
    const auto model = gaussianModel(gaussians);
    std::set<std::string> names;
    const auto found = coverage(model, everyone(model));
    for (const auto& hole : found.holes) names.insert(describe(hole, model));
    EXPECT_EQ(names.size(), found.holes.size()) << "model " << m;
  }
}

TEST(Coverage, GaussianEdgesAreThoseOfTheEvaluationToTheLastDigit) {
  base::Random random(11);
  for (int m = 0; m < 300; ++m) {
    std::vector<std::pair<double, double>> gaussians;
    for (int t = 0, count = 1 + random.below(4); t < count; ++t) {
      const double sigma = std::pow(10, random.uniform(-18, 1));
      gaussians.emplace_back(random.uniform(-10, 110), sigma);
    }
    const auto model = gaussianModel(gaussians);
    const auto compiled = fuzzy::compile(model);
    const auto found = coverage(model, everyone(model));
    ASSERT_TRUE(found.complete);
    std::vector<double> points = {0, 50, 100};
    for (const auto& [mean, sigma] : gaussians) {
      points.insert(points.end(),
                    {mean, mean + 38.6 * sigma, mean - 38.61 * sigma, mean + random.uniform(-50, 50) * sigma});
    }
    for (const auto& hole : found.holes) {
      for (const double end : {hole.ranges[0].low, hole.ranges[0].high}) {
        points.insert(points.end(), {end, std::nextafter(end, -1e9), std::nextafter(end, 1e9)});
      }
    }
    for (double x : points) {
      x = compiled->clampInput(0, x);
      int holes = 0;
      for (const auto& hole : found.holes) holes += contains(hole, {x}) ? 1 : 0;
      ASSERT_EQ(holes, compiled->evaluate(std::vector<double>{x}).fired ? 0 : 1) << "model " << m << " at " << x;
    }
  }
}

TEST(Coverage, NarrowGaussiansBesideOtherInputs) {
  base::Random random(12);
  for (int m = 0; m < 200; ++m) {
    ForceModel model = support::randomModel(random, {});
    for (auto& input : model.inputs) {
      for (auto& term : input.terms) {
        if (random.below(2) == 0) continue;
        const double width = input.max - input.min;
        term.shape = fuzzy::Shape::kGaussian;
        term.points = {random.uniform(input.min, input.max), width * std::pow(10, random.uniform(-4, -1))};
      }
    }
    const auto compiled = fuzzy::compile(model);
    ASSERT_TRUE(compiled);
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      const auto found = coverage(model, std::span(&e, 1));
      ASSERT_TRUE(found.complete);
      for (int p = 0; p < 20; ++p) {
        auto point = support::randomPoint(random, model);
        for (std::size_t i = 0; i < point.size(); ++i) point[i] = compiled->clampInput(i, point[i]);
        int holes = 0;
        for (const auto& hole : found.holes) holes += contains(hole, point) ? 1 : 0;
        ASSERT_EQ(holes, compiled->evaluateExpert(e, point).fired ? 0 : 1) << "model " << m << ", expert " << e;
      }
    }
  }
}

}  // namespace
}  // namespace tactus::analysis
