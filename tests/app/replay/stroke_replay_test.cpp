#include "app/replay/stroke_replay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/app/replay/felt_recording.h"
#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::replay {
namespace {

using fuzzy::ForceModel;

/// A stroke without a renderer: depth and speed at 1 ms, both analytic.
struct Movement {
  double from_mm, to_mm, duration_s;
  bool steady = false;  ///< at one speed; otherwise minimum jerk

  double depthMm(double time_s) const {
    const double t = time_s / duration_s;
    return from_mm + (to_mm - from_mm) * (steady ? t : minimumJerk(t));
  }
  double speedMmS(double time_s) const {
    const double t = time_s / duration_s;
    return (to_mm - from_mm) / duration_s * (steady ? 1 : 30 * t * t * (1 - t) * (1 - t));
  }
};

StrokeNumbers withoutRenderer(const Movement& movement, const ForceModel& before, const ForceModel& after) {
  const std::array compiled = {*fuzzy::compile(before), *fuzzy::compile(after)};
  std::vector<double> time_s, depth_mm, force_n[2];
  const int ticks = static_cast<int>(std::lround(movement.duration_s * 1000));
  for (int i = 0; i <= ticks; ++i) {
    time_s.push_back(i * .001);
    depth_mm.push_back(movement.depthMm(time_s.back()));
    const std::array point = {1.0, 60.0, depth_mm.back(), movement.speedMmS(time_s.back())};
    for (std::size_t side = 0; side < 2; ++side) force_n[side].push_back(compiled[side].evaluate(point).force_n);
  }
  return numbersOf({time_s, depth_mm, depth_mm, {force_n[0], force_n[1]}});
}

/// Laryngopharynx to esophagus ends at 202.1074 instead of 215 mm.
ForceModel x1() {
  ForceModel model = support::s4FiveRegions();
  model.inputs[2].terms[2].points[3] = model.inputs[2].terms[3].points[1] = 202.1074;
  return model;
}
/// Rule 3 says Large.
ForceModel x2() {
  ForceModel model = support::s4FiveRegions();
  model.experts[0].rules[2].then = "large";
  return model;
}
/// Medium begins to end, and Large to begin, at 0.55 instead of 0.6 N.
ForceModel x3() {
  ForceModel model = support::s4FiveRegions();
  model.output.terms[2].points[2] = model.output.terms[3].points[0] = .55;
  return model;
}

// Reference figures: another program (Python, sampled in the same way, exact centroid), with the digits that it
// printed.
struct Reference {
  const char* name;
  ForceModel after;
  Movement movement;
  double peak_n[2];
  double largest_n, at_mm;
  double rms_n;
  double work_mj[2];
  double time_share, path_share;
  double noticeable;
};

constexpr double kFive = 5.1e-6;  // digits printed: five decimals
constexpr double kFour = 5.1e-5;
constexpr double kThree = 5.1e-4;

TEST(StrokeNumbers, AgreeWithTheReferenceFiguresToEachPrintedDigit) {
  const Movement s1{150, 210, .8};
  const Movement s2{180, 240, .4};
  const Movement s3{190, 210, 4, true};
  const std::vector<Reference> table = {
      {"X1 s1", x1(), s1, {.61125, .65777}, .05674, 200.608, .01489, {33.3202, 33.6439}, 0, 0, .68802},
      {"X1 s2", x1(), s2, {.78788, .78788}, .10546, 201.957, .02882, {42.2325, 43.3806}, .04, .07125, 1.15986},
      {"X1 s3", x1(), s3, {.58944, .58943}, .03944, 200.000, .02440, {11.3463, 11.1404}, 0, 0, .48541},
      {"X2 s1", x2(), s1, {.61125, .73226}, .13976, 155.373, .10228, {33.3202, 39.4471}, .70438, .84266, 2.0461},
      {"X2 s2", x2(), s2, {.78788, .78892}, .13996, 181.597, .07750, {42.2325, 45.1283}, .42125, .35477, 2.0493},
      {"X2 s3", x2(), s3, {.58944, .63326}, .09301, 190.000, .04116, {11.3463, 11.9096}, .09838, .09838, 1.2393},
      {"X3 s1", x3(), s1, {.61125, .61129}, .00900, 150.000, .00455, {33.3202, 33.2489}, 0, 0, .13048},
      {"X3 s3", x3(), s3, {.58944, .58855}, .00385, 190.000, .00199, {11.3463, 11.3087}, 0, 0, .05124},
  };
  for (const Reference& row : table) {
    SCOPED_TRACE(row.name);
    const StrokeNumbers found = withoutRenderer(row.movement, support::s4FiveRegions(), row.after);
    for (std::size_t side = 0; side < 2; ++side) {
      EXPECT_NEAR(found.peak_n[side], row.peak_n[side], kFive);
      EXPECT_NEAR(found.work_mj[side], row.work_mj[side], kFour);
    }
    EXPECT_NEAR(found.largest_n, row.largest_n, kFive);
    EXPECT_NEAR(found.largest_at_mm, row.at_mm, kThree);
    EXPECT_NEAR(found.rms_n, row.rms_n, kFive);
    EXPECT_NEAR(found.time_share, row.time_share, kFive);
    EXPECT_NEAR(found.path_share, row.path_share, kFive);
    EXPECT_NEAR(found.noticeable, row.noticeable, row.noticeable >= 1.2 ? kFour : kFive);
  }
}

TEST(StrokeNumbers, ByHand) {
  // Force 0 before: one just-noticeable difference is 0.04 N. The hand goes 2 mm in and 1 mm back.
  const std::vector<double> time_s{0, 1, 2, 4}, path_mm{0, 1, 2, 1}, depth_mm{10, 11, 12, 11};
  const std::vector<double> before_n{0, 0, 0, 0}, after_n{0, .08, -.02, 0};
  const StrokeNumbers found = numbersOf({time_s, path_mm, depth_mm, {before_n, after_n}});
  EXPECT_EQ(found.largest_n, .08);
  EXPECT_EQ(found.largest_at_mm, 11);
  EXPECT_EQ(found.noticeable_by_n, .08);
  EXPECT_DOUBLE_EQ(found.noticeable, 2);
  EXPECT_DOUBLE_EQ(found.mean_n, (.08 * 1 - .02 * 1.5) / 4);
  EXPECT_DOUBLE_EQ(found.rms_n, std::sqrt((.0064 * 1 + .0004 * 1.5) / 4));
  EXPECT_DOUBLE_EQ(found.work_mj[1], .08 * 1 - .02 * .5) << "the way back does no work";
  EXPECT_DOUBLE_EQ(found.time_share, 1. / 4);
  EXPECT_DOUBLE_EQ(found.path_share, 1. / 3);
}

using Strokes = std::shared_ptr<const std::vector<RecordedStroke>>;

Strokes strokesOn(const ForceModel& model, double start_mm = 0) {
  const std::map<std::string, double> well{{"lubrication", 1}, {"neck_flexion", 60}};
  const std::map<std::string, double> poor{{"lubrication", .1}, {"neck_flexion", 10}};
  return std::make_shared<const std::vector<RecordedStroke>>(recordedStrokes(
      {{felt(model, {{60, .8, well}, {60, .4, poor}, {80, 1.5, well}, {70, .8, well}}, start_mm)}, {}, {}}));
}

StrokeComparison compared(const Strokes& strokes, const ForceModel& before, const ForceModel& after,
                          Skip skip = Skip::kUnchanged) {
  return compareStrokes(baselineOf(strokes, *editing::ready(before), {}), **editing::ready(after), skip);
}

void expectSame(const StrokeComparison& one, const StrokeComparison& other) {
  ASSERT_EQ(one.strokes.size(), other.strokes.size());
  for (std::size_t i = 0; i < one.strokes.size(); ++i) {
    EXPECT_EQ(one.strokes[i].stroke, other.strokes[i].stroke);
    EXPECT_EQ(one.strokes[i].after_n, other.strokes[i].after_n);
    EXPECT_EQ(one.strokes[i].numbers, other.strokes[i].numbers);
    EXPECT_EQ(one.strokes[i].hole_mm[1], other.strokes[i].hole_mm[1]);
  }
  EXPECT_EQ(one.summary, other.summary);
}

std::size_t askedBy(const StrokeComparison& comparison) {
  std::size_t out = 0;
  for (const ComparedStroke& one : comparison.strokes) out += one.asked;
  return out;
}

/// An edit as people make them: a word, a rule off, a weight, a vertex, an expert's weight, a word of the force.
ForceModel edited(ForceModel model, base::Random& random) {
  fuzzy::Expert& expert = model.experts[static_cast<std::size_t>(random.below(static_cast<int>(model.experts.size())))];
  auto& rule = expert.rules[static_cast<std::size_t>(random.below(static_cast<int>(expert.rules.size())))];
  const auto pick = [&](auto& list) -> auto& {
    return list[static_cast<std::size_t>(random.below(static_cast<int>(list.size())))];
  };
  const auto moveGap = [&](fuzzy::Variable& variable) {
    const auto gap = static_cast<std::size_t>(random.below(static_cast<int>(variable.terms.size()) - 1));
    auto& below = variable.terms[gap].points;
    auto& above = variable.terms[gap + 1].points;
    const double begin = below[2] + random.uniform(.05, .95) * (below[3] - below[2]);
    below[2] = above[0] = begin;
  };
  switch (random.below(6)) {
    case 0: rule.then = pick(model.output.terms).id; break;
    case 1: rule.enabled = false; break;
    case 2: rule.weight = random.uniform(); break;
    case 3: moveGap(pick(model.inputs)); break;
    case 4: expert.weight = random.uniform(.5, 2); break;
    default: moveGap(model.output); break;
  }
  return model;
}

TEST(StrokeReplay, SkippingWhereNothingChangedGivesTheSameNumbers) {
  base::Random random(7);
  for (const ForceModel& model : {support::s4FiveRegions(), support::inventedExperts()}) {
    const Strokes strokes = strokesOn(model, 60);
    const StrokeBaseline before = baselineOf(strokes, *editing::ready(model), {});
    std::size_t skipped = 0;
    for (int i = 0; i < 40; ++i) {
      const auto after = editing::ready(edited(model, random));
      ASSERT_TRUE(after) << after.error().message();
      const auto quick = compareStrokes(before, **after);
      const auto all = compareStrokes(before, **after, Skip::kNothing);
      expectSame(quick, all);
      skipped += askedBy(all) - askedBy(quick);
    }
    EXPECT_GT(skipped, 0U);
  }
}

TEST(StrokeReplay, SkippingHoldsForOddModelsToo) {
  base::Random random(11);
  int strokes_seen = 0;
  for (int i = 0; i < 60; ++i) {
    ForceModel model = support::randomModel(random);
    const char* const names[] = {"depth", "speed"};
    for (std::size_t input = 0; input < model.inputs.size(); ++input) {
      fuzzy::Variable& variable = model.inputs[input];
      const std::string old = variable.id;
      if (input > 1) continue;
      variable.id = names[input];
      variable.unit = "";
      for (fuzzy::Expert& expert : model.experts) {
        for (auto& rule : expert.rules) {
          for (auto& condition : rule.conditions)
            condition.input = condition.input == old ? variable.id : condition.input;
        }
        for (auto& own : expert.overrides) own.variable = own.variable == old ? variable.id : own.variable;
      }
    }
    model.output.unit = "";
    Conditions conditions;
    for (std::size_t input = 2; input < model.inputs.size(); ++input) {
      conditions[model.inputs[input].id] = random.uniform(model.inputs[input].min, model.inputs[input].max);
    }
    ForceModel after = model;
    if (after.experts[0].rules.empty()) continue;
    after.experts[0].rules.front().then = after.output.terms.back().id;
    RecordedStroke stroke;
    stroke.use = StrokeUse::kForceOff;
    stroke.at_press.depth_mm = std::clamp(model.inputs[0].min, -1e5, 1e5);
    stroke.at_press.position_mm = stroke.at_press.depth_mm;
    for (int tick = 0; tick < 400; ++tick) {
      stroke.dt_s.push_back(.001);
      stroke.position_mm.push_back(*stroke.at_press.position_mm + 80 * minimumJerk(tick / 399.0));
    }
    const auto before = editing::ready(model);
    const auto ready = editing::ready(after);
    if (!before || !ready) continue;
    const auto strokes = std::make_shared<const std::vector<RecordedStroke>>(std::vector{stroke});
    const StrokeBaseline baseline = baselineOf(strokes, *before, conditions);
    const auto quick = compareStrokes(baseline, **ready);
    expectSame(quick, compareStrokes(baseline, **ready, Skip::kNothing));
    strokes_seen += static_cast<int>(quick.strokes.size());
  }
  EXPECT_GT(strokes_seen, 20);
}

TEST(StrokeReplay, AStrokeOutsideTheChangedRegionAsksNothing) {
  const ForceModel model = support::s4FiveRegions();
  const Strokes strokes = strokesOn(model);  // down to 270 mm
  ForceModel after = model;
  after.inputs[2].terms[3].points[2] = after.inputs[2].terms[4].points[0] = 430;  // the stomach begins later
  after.experts[0].rules[4].then = "large";                                       // well lubricated, stomach
  const auto found = compared(strokes, model, after);
  ASSERT_EQ(found.strokes.size(), 4U);
  // The hull of the changed terms is esophagus and stomach: only the way from 185 mm on counts.
  for (const ComparedStroke& one : found.strokes) {
    EXPECT_EQ(one.numbers->noticeable, 0);
    EXPECT_EQ(one.numbers->work_mj[0], one.numbers->work_mj[1]);
    if (one.stroke < 2) {
      EXPECT_EQ(one.asked, 0U) << one.stroke;
    }
  }
  EXPECT_EQ(found.summary.felt, 0U);
}

TEST(StrokeReplay, TheSameModelMakesNoDifference) {
  const ForceModel model = support::inventedExperts();
  const auto found = compared(strokesOn(model), model, model);
  ASSERT_EQ(found.strokes.size(), 4U);
  EXPECT_EQ(askedBy(found), 0U);
  for (const ComparedStroke& one : found.strokes) {
    EXPECT_EQ(one.numbers->largest_n, 0);
    EXPECT_EQ(one.numbers->rms_n, 0);
    EXPECT_EQ(one.numbers->peak_n[0], one.numbers->peak_n[1]);
  }
}

TEST(StrokeReplay, TheWorstStrokeComesFirst) {
  const ForceModel model = support::s4FiveRegions();
  const auto found = compared(strokesOn(model, 100), model, x2());
  ASSERT_EQ(found.strokes.size(), 4U);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_GE(found.strokes[i - 1].numbers->noticeable, found.strokes[i].numbers->noticeable);
  }
  EXPECT_EQ(found.summary.worst, 0U);
  EXPECT_EQ(found.summary.compared, 4U);
  EXPECT_EQ(found.summary.left_out, 0U);
  const StrokeNumbers& worst = *found.strokes[0].numbers;
  EXPECT_GE(worst.noticeable, 1) << "rule 3 holds for two well lubricated strokes in the laryngopharynx";
  EXPECT_GT(worst.noticeable_by_n, 0);
  EXPECT_GT(worst.noticeable_at_mm, 105);
  EXPECT_LT(worst.noticeable_at_mm, 215);
  std::size_t felt = 0;
  for (const ComparedStroke& one : found.strokes) felt += one.numbers->noticeable >= 1 ? 1 : 0;
  EXPECT_EQ(found.summary.felt, felt);
  const double middle = (found.strokes[1].numbers->noticeable + found.strokes[2].numbers->noticeable) / 2;
  EXPECT_EQ(found.summary.median_noticeable, middle);
}

TEST(StrokeReplay, AHoleIsReportedAndNotBridged) {
  const ForceModel model = support::s4FiveRegions();
  ForceModel after = model;
  for (auto& rule : after.experts[0].rules) {
    for (const auto& condition : rule.conditions) {
      if (condition.term == "laryngopharynx") rule.enabled = false;
    }
  }
  const Strokes strokes = strokesOn(model, 100);
  const auto found = compared(strokes, model, after);
  EXPECT_GT(found.summary.holes, 0U);
  EXPECT_EQ(found.summary.holes + found.summary.compared, found.strokes.size());
  const ComparedStroke& first = found.strokes[0];
  EXPECT_FALSE(first.numbers);
  EXPECT_FALSE(first.hole_mm[0]);
  ASSERT_TRUE(first.hole_mm[1]);
  EXPECT_GE(*first.hole_mm[1], 125);
  EXPECT_LE(*first.hole_mm[1], 185);
  // The other way around: the hole was there before, and the edit closed it.
  const auto closed = compared(strokes, after, model);
  EXPECT_EQ(closed.summary.holes, 0U);
  EXPECT_FALSE(closed.strokes.back().numbers);
}

TEST(StrokeReplay, AStifferSpringIsADifferenceEverywhere) {
  const ForceModel model = support::s4FiveRegions();
  ForceModel after = model;
  after.renderer = fuzzy::RendererParameters{};
  after.renderer->stiffness_n_mm *= 2;
  const Strokes strokes = strokesOn(model);
  const auto found = compared(strokes, model, after);
  EXPECT_GT(found.strokes[0].numbers->largest_n, 0);
  expectSame(found, compared(strokes, model, after, Skip::kNothing));
}

TEST(StrokeReplay, PuncturesOfBothModelsAreFelt) {
  ForceModel model = support::s4FiveRegions();
  model.events = {{"laryngopharynx", .6}};
  const Strokes strokes = strokesOn(model);
  ForceModel none = model;
  none.events.clear();
  EXPECT_EQ(compared(strokes, model, model).summary.felt, 0U);
  const auto lost = compared(strokes, model, none);
  EXPECT_GT(lost.strokes[0].numbers->largest_n, .05);
  expectSame(lost, compared(strokes, model, none, Skip::kNothing));
  base::Random random(36);
  for (int i = 0; i < 20; ++i) {
    const ForceModel after = edited(model, random);
    expectSame(compared(strokes, model, after), compared(strokes, model, after, Skip::kNothing));
    if (HasFatalFailure()) return;
  }
}

TEST(StrokeReplay, WithoutAForceTheConditionsAreThoseThatAreGiven) {
  RecordedStroke stroke;
  stroke.use = StrokeUse::kForceOff;
  stroke.at_press.depth_mm = stroke.at_press.position_mm.emplace(100);
  for (int tick = 0; tick <= 800; ++tick) {
    stroke.dt_s.push_back(.001);
    stroke.position_mm.push_back(100 + 60 * minimumJerk(tick / 800.0));
  }
  const auto strokes = std::make_shared<const std::vector<RecordedStroke>>(std::vector{stroke});
  const auto model = *editing::ready(support::s4FiveRegions());
  const auto refused = baselineOf(strokes, model, {});
  EXPECT_FALSE(refused.runs[0]);
  ASSERT_TRUE(refused.refusal);
  EXPECT_EQ(compareStrokes(refused, *model).summary.left_out, 1U);
  const auto given = baselineOf(strokes, model, {{"lubrication", 1}, {"neck_flexion", 60}});
  ASSERT_TRUE(given.runs[0]);
  EXPECT_GT(compareStrokes(given, **editing::ready(x2())).summary.felt, 0U);
}

TEST(StrokeReplay, WhatCannotBeReproducedIsLeftOut) {
  auto strokes = *strokesOn(support::s4FiveRegions());
  strokes[1].use = StrokeUse::kOtherForce;
  strokes[2].use = StrokeUse::kUnknownModel;
  const auto found =
      compared(std::make_shared<const std::vector<RecordedStroke>>(strokes), support::s4FiveRegions(), x2());
  EXPECT_EQ(found.strokes.size(), 2U);
  EXPECT_EQ(found.summary.left_out, 2U);
  for (const ComparedStroke& one : found.strokes) EXPECT_TRUE(one.stroke == 0 || one.stroke == 3);
}

}  // namespace
}  // namespace tactus::replay
