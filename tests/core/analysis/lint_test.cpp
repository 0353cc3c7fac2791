#include "core/analysis/lint.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/analysis/directions.h"

#include "tests/support/ngt_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;
using Kind = Finding::Kind;

std::vector<Finding> findings(const ForceModel& model, Kind kind) {
  auto all = lint(model, *fuzzy::compile(model)).findings;
  std::erase_if(all, [kind](const Finding& finding) { return finding.kind != kind; });
  return all;
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
  const auto of = [&](std::size_t input) { return direction(model, model.experts[0], model.inputs[input]); };
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
  ForceModel model = support::s4AsPrinted();
  // Two experts for whom a flexed neck lowers the force: S4's rules with small and large flexion exchanged.
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
  const auto disagreements = findings(model, Kind::kDisagreement);
  ASSERT_EQ(disagreements.size(), 1);
  EXPECT_EQ(disagreements[0].expert, "S4");
  EXPECT_EQ(disagreements[0].place, "neck_flexion");
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

}  // namespace
}  // namespace tactus::analysis
