#include <gtest/gtest.h>

#include "core/analysis/directions.h"
#include "core/analysis/rule_table.h"

#include "tests/support/ngt_model.h"

namespace tactus::analysis {
namespace {

// Table A2 has three terms of each condition in five regions: two steps each along the condition, four along the depth.
TEST(RuleSteps, OfTheFullTable) {
  const auto model = support::s4AsPrinted();
  const auto steps = [&](std::size_t input) { return neighborSteps(model, model.experts[0], input); };
  EXPECT_EQ(steps(0).size(), 10U);
  EXPECT_EQ(steps(1).size(), 10U);
  EXPECT_EQ(steps(2).size(), 36U);
  EXPECT_EQ(steps(3).size(), 10U);
  for (const auto& step : steps(3)) {
    EXPECT_TRUE(step.adjacent);
    EXPECT_GT(step.levels, 0) << "each row of the speed rises from left to right in Table A2";
  }
  // The printed table has no oropharynx, so nasopharynx and laryngopharynx are no neighbors.
  int gaps = 0;
  for (const auto& step : steps(2)) gaps += step.adjacent ? 0 : 1;
  EXPECT_EQ(gaps, 9);
}

TEST(RuleSteps, LevelsAndWords) {
  auto model = support::s4AsPrinted();
  const auto& expert = model.experts[0];
  bool found = false;
  for (const auto& step : neighborSteps(model, expert, 0)) {
    const std::string text = describe(step, model, expert);
    if (text.find("from poor to medium where depth is nasopharynx") == std::string::npos) continue;
    found = true;
    EXPECT_EQ(text, "lubrication from poor to medium where depth is nasopharynx, force from very_large to small");
    EXPECT_EQ(step.levels, -3);
    EXPECT_EQ(expert.rules[step.before].then, "very_large");
    EXPECT_EQ(expert.rules[step.after].then, "small");
  }
  EXPECT_TRUE(found);
}

TEST(RuleSteps, RulesThatDoNotCountMakeNoStep) {
  auto model = support::s4AsPrinted();
  for (auto& rule : model.experts[0].rules) {
    for (const auto& condition : rule.conditions) {
      if (condition.input == "speed" && condition.term == "medium") rule.enabled = false;
      if (condition.input == "speed" && condition.term == "slow") rule.weight = 0;
    }
  }
  EXPECT_TRUE(neighborSteps(model, model.experts[0], 3).empty());
}

TEST(RuleSteps, OfTwoRulesForTheSameEachMakesItsStep) {
  auto model = support::s4AsPrinted();
  model.experts[0].rules = {{{{"speed", "slow"}}, "small", 1, true},
                            {{{"speed", "slow"}}, "large", 1, true},
                            {{{"speed", "fast"}}, "medium", 1, true}};
  const auto steps = neighborSteps(model, model.experts[0], 3);
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].levels, 1);
  EXPECT_EQ(steps[1].levels, -1);
  EXPECT_FALSE(steps[0].adjacent);
}

// Levels follow the centres of the terms, not the order in which they are listed.
TEST(RuleSteps, TheOrderOfTheTermsInTheFileDoesNotMatter) {
  auto model = support::s4AsPrinted();
  const auto before = neighborSteps(model, model.experts[0], 0);
  std::swap(model.output.terms[0], model.output.terms[4]);
  std::swap(model.inputs[0].terms[0], model.inputs[0].terms[2]);
  const auto after = neighborSteps(model, model.experts[0], 0);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t k = 0; k < after.size(); ++k) {
    EXPECT_EQ(after[k].before, before[k].before);
    EXPECT_EQ(after[k].levels, before[k].levels);
  }
}

// `narrow` and `wide` lie about the same speed, `small` and `wide_small` about the same force: neither is above the
// other, whatever their order in the file.
TEST(RuleSteps, TermsWithTheSameCentreShareAPlace) {
  auto model = support::s4AsPrinted();
  using fuzzy::Shape;
  model.inputs[3].terms = {{"narrow", "narrow", Shape::kTriangle, {90, 100, 110}},
                           {"wide", "wide", Shape::kTriangle, {0, 100, 200}},
                           {"fast", "fast", Shape::kTriangle, {200, 300, 400}}};
  model.output.terms = {{"small", "small", Shape::kTriangle, {.25, .5, .75}},
                        {"wide_small", "wide small", Shape::kTriangle, {0, .5, 1}},
                        {"large", "large", Shape::kTriangle, {.5, .75, 1}}};
  model.experts[0].overrides.clear();
  model.experts[0].rules = {{{{"speed", "narrow"}}, "large", 1, true},
                            {{{"speed", "wide"}}, "small", 1, true},
                            {{{"speed", "fast"}}, "wide_small", 1, true}};
  const auto steps = neighborSteps(model, model.experts[0], 3);
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].levels, -1);
  EXPECT_EQ(steps[1].levels, 0);
  EXPECT_TRUE(steps[0].adjacent && steps[1].adjacent);
  const auto found = direction(model, model.experts[0], 3);
  EXPECT_EQ(found.prevailing, Direction::kFalls);
  EXPECT_EQ(found.steps_with.size(), 1U);
}

// A rule of weight 0 never fires, so it has no say in the direction either.
TEST(RuleSteps, RulesThatDoNotCountHaveNoDirection) {
  auto model = support::s4AsPrinted();
  for (auto& rule : model.experts[0].rules) rule.weight = 0;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    EXPECT_EQ(direction(model, model.experts[0], i).prevailing, Direction::kMixed);
  }
}

}  // namespace
}  // namespace tactus::analysis
