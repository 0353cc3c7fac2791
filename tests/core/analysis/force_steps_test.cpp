#include "core/analysis/force_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "core/base/random.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;
using Point = std::vector<double>;

double jnd(double force_n) { return std::hypot(0.04, 0.12 * force_n); }

StepLimits limits() {
  StepLimits out;
  out.noticeable = jnd;
  return out;
}

std::vector<ForceStep> along(const ForceModel& model, std::size_t input, const Point& point) {
  return forceStepsAlong(model, fuzzy::compile(model).value(), input, point, limits());
}

std::vector<ForceStep> everywhere(const ForceModel& model) {
  const auto compiled = fuzzy::compile(model).value();
  ForceProbe probe(model, compiled, 100'000'000);
  return forceSteps(probe, limits(), 60'000);
}

/// Depth 0 to 100 mm: `left` gives 0.25 N alone, `right` 0.55 N.
ForceModel twoRegions(Point left, Point right) {
  ForceModel model;
  model.inputs = {{"depth", "", "mm", 0, 100, {}}};
  model.inputs[0].terms = {{"left", "", fuzzy::Shape::kTrapezoid, std::move(left)},
                           {"right", "", fuzzy::Shape::kTrapezoid, std::move(right)}};
  model.output = {"force", "", "N", 0, 1, {}};
  model.output.terms = {{"small", "", fuzzy::Shape::kTrapezoid, {0.2, 0.2, 0.3, 0.3}},
                        {"large", "", fuzzy::Shape::kTrapezoid, {0.5, 0.5, 0.6, 0.6}}};
  model.experts = {{"A", "", 1, {}, {{{{"depth", "left"}}, "small"}, {{{"depth", "right"}}, "large"}}}};
  return model;
}

TEST(ForceSteps, NoneInTheModelOfTheTables) { EXPECT_TRUE(everywhere(support::s4AsPrinted()).empty()); }

// Both edges vertical at 40 mm: at the edge itself both regions hold, so the mean goes from 0.25 over 0.4 to 0.55 N.
TEST(ForceSteps, AVerticalEdgeIsAStepWithinNoMillimeter) {
  const auto steps = along(twoRegions({0, 0, 40, 40}, {40, 40, 100, 100}), 0, {0});
  ASSERT_EQ(steps.size(), 2U);  // of the mean and of the expert
  EXPECT_FALSE(steps[0].expert.has_value());
  EXPECT_EQ(steps[1].expert, 0U);
  for (const auto& step : steps) {
    EXPECT_NEAR(step.from_n, 0.25, 1e-12);
    EXPECT_NEAR(step.to_n, 0.55, 1e-12);
    EXPECT_NEAR(step.noticeable, 0.3 / jnd(0.25), 1e-9);
    EXPECT_LT(step.to[0] - step.from[0], 1e-10);
    EXPECT_NEAR(step.from[0], 40, 1e-10);
  }
}

// One hairline between two flanks of 20 mm: no edge is steep, but what is left of the left region is nothing where the
// right one begins.
TEST(ForceSteps, ShallowFlanksThatOnlyMeetAreAStep) {
  const auto steps = along(twoRegions({0, 0, 20, 40}, {40 - 1e-4, 60, 100, 100}), 0, {0});
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_GT(steps[0].noticeable, 0.95 * 0.3 / jnd(0.25));
  EXPECT_LE(steps[0].to[0] - steps[0].from[0], 1 + 1e-9);
  EXPECT_NEAR(steps[0].from[0], 40, 1);
}

// A place of no width without a force is passed; a gap is a hole and not a step.
TEST(ForceSteps, AGapIsNoStep) {
  EXPECT_EQ(along(twoRegions({0, 0, 20, 40}, {40, 60, 100, 100}), 0, {0}).size(), 2U);
  EXPECT_TRUE(along(twoRegions({0, 0, 20, 40}, {40.5, 60, 100, 100}), 0, {0}).empty());
}

// With equal areas and scaled terms the force is linear in the membership: 0.3 N over the width of the crossing.
TEST(ForceSteps, ACrossingIsAStepWhereItIsNarrowEnough) {
  const auto crossing = [](double width_mm) {
    auto model =
        twoRegions({0, 0, 50 - width_mm / 2, 50 + width_mm / 2}, {50 - width_mm / 2, 50 + width_mm / 2, 100, 100});
    model.implication = fuzzy::Implication::kScale;
    return along(model, 0, {0});
  };
  // One millimeter has 0.3 / width N; the threshold at 0.25 N is 0.05 N, and at 0.3 N more.
  EXPECT_TRUE(crossing(6.1).empty());
  const auto steps = crossing(5);
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_NEAR(steps[0].to_n - steps[0].from_n, 0.06, 1e-9);
  EXPECT_NEAR(steps[0].noticeable, 0.06 / jnd(0.25), 0.01);
}

// 0.25 to 0.26 N at an edge: no hand feels 0.01 N, but no spring of 0.25 N/mm follows it.
TEST(ForceSteps, ASmallEdgeIsSteeperThanTheRenderer) {
  auto model = twoRegions({0, 0, 40, 40}, {40, 40, 100, 100});
  model.output.terms[1].points = {0.21, 0.21, 0.31, 0.31};
  const auto steps = along(model, 0, {0});
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_LT(steps[0].noticeable, 1);
  EXPECT_NEAR(steps[0].to_n - steps[0].from_n, 0.01, 1e-12);
  model.inputs[0].unit = "s";  // no spring along time
  EXPECT_TRUE(along(model, 0, {0}).empty());
}

TEST(ForceSteps, OtherUnitsHaveA250thOfTheUniverse) {
  EXPECT_EQ(stepWidth({"depth", "", "mm", 0, 600, {}}), 1);
  EXPECT_EQ(stepWidth({"speed", "", "mm/s", 0, 400, {}}), 1.6);
}

/// The largest change within one step width over 3,000 even places, in noticeable differences, where the experts who
/// fire stay the same; one number for the mean and each expert.
std::vector<double> sampled(const ForceModel& model, const fuzzy::CompiledModel& compiled, std::size_t input,
                            Point point, const StepLimits& limit) {
  constexpr int kPlaces = 3000;
  const auto& variable = model.inputs[input];
  const std::size_t count = model.experts.size() + 1;
  std::vector<std::vector<fuzzy::Evaluation>> forces(count);
  std::vector<int> mean_piece = {0};
  for (int k = 0; k <= kPlaces; ++k) {
    point[input] = variable.min + (variable.max - variable.min) * k / kPlaces;
    forces[0].push_back(compiled.evaluate(point));
    bool same = true;
    for (std::size_t e = 0; e + 1 < count; ++e) {
      forces[e + 1].push_back(compiled.evaluateExpert(e, point));
      if (k > 0 && compiled.weight(e) > 0)
        same = same && forces[e + 1][static_cast<std::size_t>(k) - 1].fired == forces[e + 1].back().fired;
    }
    if (k > 0) mean_piece.push_back(mean_piece.back() + (same ? 0 : 1));
  }
  const auto within = static_cast<std::size_t>(stepWidth(variable) / (variable.max - variable.min) * kPlaces);
  std::vector<double> out(count, 0);
  for (std::size_t who = 0; who < count; ++who) {
    for (std::size_t k = 0; k < forces[who].size(); ++k) {
      for (std::size_t j = k + 1; j < forces[who].size() && j <= k + within; ++j) {
        if (!forces[who][j].fired || !forces[who][k].fired || (who == 0 && mean_piece[j] != mean_piece[k])) break;
        const double one = forces[who][k].force_n;
        const double other = forces[who][j].force_n;
        out[who] =
            std::max(out[who], std::abs(other - one) / limit.noticeable(std::min(std::abs(one), std::abs(other))));
      }
    }
  }
  return out;
}

TEST(ForceSteps, AgreeWithSamplesOfGeneratedModels) {
  base::Random random(14);
  int with_steps = 0;
  int without = 0;
  for (int i = 0; i < 150; ++i) {
    const ForceModel model = support::randomModel(random, {i % 3 == 0, false});
    const auto compiled = fuzzy::compile(model).value();
    const auto input = static_cast<std::size_t>(random.below(static_cast<int>(model.inputs.size())));
    StepLimits limit;
    const double range = model.output.max - model.output.min;
    limit.noticeable = [range](double force_n) { return 0.015 * range + 0.05 * force_n; };
    limit.smallest_n = 1e-6 * range;
    limit.stiffness_n_mm = 1e9 * range;
    Point point;
    for (const auto& variable : model.inputs) point.push_back(random.uniform(variable.min, variable.max));
    const auto steps = forceStepsAlong(model, compiled, input, point, limit);
    std::vector<double> largest(model.experts.size() + 1, 0);
    for (const auto& step : steps) {
      const std::size_t who = step.expert ? *step.expert + 1 : 0;
      largest[who] = std::max(largest[who], step.noticeable);
      EXPECT_GT(step.noticeable, 1);
      // What it says is so.
      const auto force = [&](const Point& at) {
        return who == 0 ? compiled.evaluate(at) : compiled.evaluateExpert(who - 1, at);
      };
      EXPECT_TRUE(force(step.from).fired && force(step.to).fired);
      EXPECT_EQ(force(step.from).force_n, step.from_n);
      EXPECT_EQ(force(step.to).force_n, step.to_n);
      EXPECT_LE(step.to[input] - step.from[input], stepWidth(model.inputs[input]) * (1 + 1e-9));
      for (std::size_t k = 0; k < point.size(); ++k) {
        EXPECT_TRUE(k == input || step.from[k] == point[k]);
      }
    }
    const auto reference = sampled(model, compiled, input, point, limit);
    for (std::size_t who = 0; who < reference.size(); ++who) {
      // The windows of the samples are at most a hundredth narrower or elsewhere.
      EXPECT_TRUE(reference[who] < 1.03 || largest[who] >= 0.97 * reference[who])
          << "model " << i << " who " << who << ": " << largest[who] << " of " << reference[who];
      reference[who] > 1 ? ++with_steps : ++without;
    }
  }
  EXPECT_GT(with_steps, 40);
  EXPECT_GT(without, 100);
}

// With inputs beside it the step is looked for over their settings: it is there only where `wet` holds.
TEST(ForceSteps, TheSettingOfTheOtherInputsIsFound) {
  auto model = twoRegions({0, 0, 40, 40}, {40, 40, 100, 100});
  model.inputs.push_back({"water", "", "1", 0, 1, {}});
  model.inputs[1].terms = {{"wet", "", fuzzy::Shape::kTrapezoid, {0.6, 0.7, 1, 1}},
                           {"dry", "", fuzzy::Shape::kTrapezoid, {0, 0, 0.5, 0.7}}};
  model.experts[0].rules = {{{{"depth", "left"}, {"water", "wet"}}, "small"},
                            {{{"depth", "right"}, {"water", "wet"}}, "large"},
                            {{{"water", "dry"}}, "small"}};
  const auto steps = everywhere(model);
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].input, 0U);
  EXPECT_GE(steps[0].from[1], 0.7);
  EXPECT_NEAR(steps[0].to_n - steps[0].from_n, 0.3, 1e-12);
}

}  // namespace
}  // namespace tactus::analysis
