#include "core/analysis/lint.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/analysis/directions.h"
#include "core/base/random.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;
using Kind = Finding::Kind;

std::vector<Finding> findings(const ForceModel& model, Kind kind) {
  auto all = lint(model, *fuzzy::compile(model)).findings;
  std::erase_if(all, [kind](const Finding& finding) { return finding.kind != kind; });
  return all;
}

/// S4, and two experts for whom a flexed neck lowers the force: S4's rules with small and large flexion exchanged.
ForceModel s4AgainstTwo() {
  ForceModel model = support::s4AsPrinted();
  for (const char* id : {"S1", "S2"}) {
    auto expert = model.experts[0];
    expert.id = id;
    for (auto& rule : expert.rules) {
      auto& condition = rule.conditions[0];
      if (condition.input == "neck_flexion" && condition.term != "medium") {
        condition.term = condition.term == "small" ? "large" : "small";
      }
    }
    model.experts.push_back(expert);
  }
  return model;
}

TEST(Lint, NamesTheHoleOfTheMeanAndOfTheExpert) {
  const auto holes = findings(support::s4AsPrinted(), Kind::kHole);
  ASSERT_EQ(holes.size(), 2);
  EXPECT_EQ(holes[0].expert, "");
  EXPECT_EQ(holes[1].expert, "S4");
  EXPECT_EQ(holes[1].place, "depth 125 to 138 mm");
}

TEST(Lint, SameConditionsWithAnotherConsequentAreAConflict) {
  ForceModel model = support::s4AsPrinted();
  auto rule = model.experts[0].rules[0];
  std::swap(rule.conditions[0], rule.conditions[1]);
  rule.then = "large";
  model.experts[0].rules.push_back(rule);
  const auto conflicts = findings(model, Kind::kConflict);
  ASSERT_EQ(conflicts.size(), 1);
  EXPECT_EQ(conflicts[0].place, "depth is nasal_cavity and lubrication is well");
  model.experts[0].rules.back().enabled = false;
  EXPECT_TRUE(findings(model, Kind::kConflict).empty());
}

// Read off Table A2: better lubrication never means more force, a flexed neck and speed never less.
TEST(Lint, DirectionsOfS4) {
  const ForceModel model = support::s4AsPrinted();
  const auto of = [&](std::size_t input) { return direction(model, model.experts[0], input); };
  EXPECT_EQ(of(0).prevailing, Direction::kFalls);
  EXPECT_EQ(of(1).prevailing, Direction::kRises);
  EXPECT_EQ(of(2).prevailing, Direction::kMixed);
  EXPECT_EQ(of(3).prevailing, Direction::kRises);
  EXPECT_TRUE(of(0).steps_against.empty() && of(1).steps_against.empty() && of(3).steps_against.empty());
}

TEST(Lint, AStepAgainstTheDirectionIsFound) {
  ForceModel model = support::s4AsPrinted();
  for (auto& rule : model.experts[0].rules) {
    if (rule.conditions[0].term == "fast" && rule.conditions[1].term == "stomach") rule.then = "very_small";
  }
  const auto changes = findings(model, Kind::kDirectionChange);
  ASSERT_EQ(changes.size(), 1);
  EXPECT_EQ(changes[0].place, "speed from medium to fast where depth is stomach, force from small to very_small");
}

TEST(Lint, AnExpertAgainstTheOthersIsNamed) {
  const ForceModel model = s4AgainstTwo();
  const auto disagreements = findings(model, Kind::kDisagreement);
  ASSERT_EQ(disagreements.size(), 1);
  EXPECT_EQ(disagreements[0].expert, "S4");
  EXPECT_EQ(disagreements[0].place, "neck_flexion");
}

TEST(Lint, HugeWeightsChangeNoDifference) {
  ForceModel model = s4AgainstTwo();
  const auto newtons = [&model] { return findings(model, Kind::kDisagreement).at(0).newtons; };
  const auto small = newtons();
  ASSERT_TRUE(small.has_value());
  for (auto& expert : model.experts) expert.weight = 1.5e308;
  EXPECT_EQ(newtons(), small);
}

TEST(Lint, UnusedTerms) {
  const auto unused = findings(support::s4AsPrinted(), Kind::kUnusedTerm);
  ASSERT_EQ(unused.size(), 1);
  EXPECT_EQ(unused[0].place, "depth oropharynx");
}

// The centroids of the two end terms alone, from the vertices: .0316667 / .25 = .126667 and .323333 / .35 = .923810.
TEST(Lint, TheReachableRangeStopsShortOfTheUniverse) {
  const ForceModel model = support::s4AsPrinted();
  const auto range = lint(model, *fuzzy::compile(model)).reachable;
  EXPECT_NEAR(range.min_n, 0.126667, 1e-6);
  EXPECT_LE(range.max_n, 0.923810);
  EXPECT_GT(range.max_n, 0.7);
  EXPECT_GT(range.fired, range.points / 2);
}

std::optional<Finding> only(const ForceModel& model, Kind kind) {
  const auto found = findings(model, kind);
  EXPECT_EQ(found.size(), 1);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

// Alone, at a well lubricated nose, very_small gives .0316667 / .25 N and large .7 N.
TEST(LintNewtons, OfAConflictLieBetweenTheTwoRulesAlone) {
  ForceModel model = support::s4AsPrinted();
  auto rule = model.experts[0].rules[0];
  rule.then = "large";
  model.experts[0].rules.push_back(rule);
  EXPECT_NEAR(only(model, Kind::kConflict)->newtons.value(), .7 - .19 / 6 / .25, 1e-12);
}

TEST(LintNewtons, OfADirectionChangeAreTheForceAlongTheStep) {
  ForceModel model = support::s4AsPrinted();
  for (auto& rule : model.experts[0].rules) {
    if (rule.conditions[0].term == "fast" && rule.conditions[1].term == "stomach") rule.then = "very_small";
  }
  const auto change = only(model, Kind::kDirectionChange);
  const auto compiled = fuzzy::compile(model);
  ASSERT_EQ(change->from.size(), 4);
  EXPECT_EQ(change->from[3], 110);
  EXPECT_EQ(change->to[3], 281.5);
  EXPECT_GT(change->newtons, 0.01);
  EXPECT_EQ(change->newtons, compiled->evaluate(change->from).force_n - compiled->evaluate(change->to).force_n);
}

TEST(LintNewtons, OfADisagreementAreTheDifferentChanges) {
  const ForceModel model = s4AgainstTwo();
  const auto found = only(model, Kind::kDisagreement);
  const auto compiled = fuzzy::compile(model);
  const auto change = [&](std::size_t e) {
    return compiled->evaluateExpert(e, found->to).force_n - compiled->evaluateExpert(e, found->from).force_n;
  };
  EXPECT_EQ(found->from[1], 0);
  EXPECT_EQ(found->to[1], 90);
  EXPECT_GT(found->newtons, 0.1);
  EXPECT_NEAR(found->newtons.value(), std::abs(change(0) - (change(1) + change(2)) / 2), 1e-14);
}

// A second expert with five regions continues where S4's oropharynx is missing.
TEST(LintNewtons, OfAnAbstentionJumpAreReproduced) {
  ForceModel model = support::s4AsPrinted();
  auto other = support::s4FiveRegions();
  other.experts[0].id = "S1";
  other.experts[0].overrides.push_back({"depth", other.inputs[2].terms});
  for (auto& rule : other.experts[0].rules) rule.then = "large";
  model.experts.push_back(other.experts[0]);
  const auto jump = only(model, Kind::kAbstentionJump);
  EXPECT_EQ(jump->expert, "S4");
  EXPECT_EQ(jump->place, "depth 125 to 138 mm");
  const auto compiled = fuzzy::compile(model);
  EXPECT_EQ(jump->newtons, std::abs(compiled->evaluate(jump->to).force_n - compiled->evaluate(jump->from).force_n));
  // S1 says .7 N everywhere. Beside the gap S4 has very_large and large at most (a bar on [.6, 1.1], .85 N) and small
  // at least (not below the support of small, .2 N), so the mean moves by at most half of .5 N.
  EXPECT_GT(jump->newtons, 0.05);
  EXPECT_LT(jump->newtons, 0.25);
}

TEST(Lint, RedundantAndUnreachable) {
  ForceModel model = support::s4AsPrinted();
  auto& rules = model.experts[0].rules;
  rules.push_back({{{"depth", "stomach"}}, "large"});
  EXPECT_EQ(findings(model, Kind::kRedundantRule).size(), 2) << "lubrication poor and speed fast in the stomach";
  EXPECT_EQ(findings(model, Kind::kRedundantRule)[0].newtons, 0);
  EXPECT_TRUE(findings(model, Kind::kUnreachableRule).empty());
  EXPECT_TRUE(findings(model, Kind::kUnreachableTerm).empty());

  model.inputs[2].terms[5].points = {600, 650, 700, 700};  // the stomach begins where the universe ends
  EXPECT_EQ(findings(model, Kind::kUnreachableRule).size(), 10);
  EXPECT_EQ(only(model, Kind::kUnreachableTerm)->place, "depth stomach");

  for (auto& rule : rules) rule.enabled = rule.then != "very_small";
  const auto terms = findings(model, Kind::kUnreachableTerm);
  ASSERT_EQ(terms.size(), 2);
  EXPECT_EQ(terms[1].place, "force very_small");
}

TEST(Lint, WhatWasSeenLiesWithinTheBounds) {
  base::Random random(51);
  for (int m = 0; m < 20; ++m) {
    const ForceModel model = support::randomModel(random, {.gaussians = m % 3 == 0});
    const auto result = lint(model, *fuzzy::compile(model));
    if (result.reachable.fired == 0) continue;
    ASSERT_TRUE(result.bounds.has_value());
    ASSERT_LE(result.bounds->min_n, result.reachable.min_n);
    ASSERT_GE(result.bounds->max_n, result.reachable.max_n);
  }
}

}  // namespace
}  // namespace tactus::analysis
