#include <algorithm>
#include <gtest/gtest.h>
#include <span>

#include "app/editing/edit.h"
#include "app/editing/lint_fixes.h"
#include "app/editing/step_fixes.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

using Names = std::vector<std::string>;
using Points = std::vector<double>;

const std::string kHole = "depth 125 to 138 mm";  // Table A2 has no oropharynx

/// The hole of its first expert.
analysis::Hole holeOf(const fuzzy::ForceModel& model) {
  const std::size_t first = 0;
  return analysis::coverage(model, std::span(&first, 1)).holes.at(0);
}

fuzzy::ForceModel accepted() { return must(acceptHole(support::s4AsPrinted(), kHole)).model; }

/// The right foot of the nasopharynx, where the hole begins, at `to_mm`.
fuzzy::ForceModel holeFrom(const fuzzy::ForceModel& model, double to_mm) {
  return must(moveVertex(model, {kDepth, "nasopharynx", 3}, to_mm)).model;
}

TEST(HoleAcceptance, IsGivenAndTakenBackWithoutATrace) {
  const auto model = support::s4AsPrinted();
  EXPECT_EQ(holeNames(model), Names{kHole});
  EXPECT_EQ(accepted().accepted_holes, Names{kHole});
  EXPECT_TRUE(lapsedAcceptances(accepted()).empty());
  EXPECT_TRUE(sameBits(must(withdrawAcceptance(accepted(), kHole)).model, model));
  EXPECT_NE(refusal(acceptHole(accepted(), kHole)).find("already"), std::string::npos);
  EXPECT_NE(refusal(withdrawAcceptance(model, kHole)).find(kHole), std::string::npos);
}

TEST(HoleAcceptance, LapsesWithTheBoundaryAndHoldsAgainWhenItIsBack) {
  const auto moved = holeFrom(accepted(), 120);
  EXPECT_EQ(holeNames(moved), Names{"depth 120 to 138 mm"});
  EXPECT_EQ(moved.accepted_holes, Names{kHole});
  EXPECT_EQ(lapsedAcceptances(moved), Names{kHole});
  EXPECT_TRUE(lapsedAcceptances(holeFrom(moved, 125)).empty());
}

TEST(HoleAcceptance, TheHoleAsItIsNowTakesThePlaceOfTheOldOne) {
  const auto edit = must(acceptHole(holeFrom(accepted(), 120), "depth 120 to 138 mm"));
  EXPECT_EQ(edit.model.accepted_holes, Names{"depth 120 to 138 mm"});
  EXPECT_NE(edit.label.find("in the place of " + kHole), std::string::npos) << edit.label;
}

TEST(HoleAcceptance, WhatLapsedIsForgottenOnRequest) {
  const auto closed = must(moveVertex(accepted(), {kDepth, "nasopharynx", 3}, 140)).model;
  EXPECT_EQ(holeNames(closed), Names{});
  EXPECT_TRUE(must(forgetLapsed(closed)).model.accepted_holes.empty());
  EXPECT_FALSE(refusal(forgetLapsed(accepted())).empty());
}

TEST(HoleAcceptance, AFixThatClosesTheHoleTakesItAlong) {
  const auto ways = closeHole(accepted(), "S4", holeOf(accepted()));
  ASSERT_EQ(ways.size(), 3);
  EXPECT_TRUE(must(ways[0].second).model.accepted_holes.empty());
  EXPECT_EQ(ways[2].first, "Take the acceptance back");
}

TEST(HoleAcceptance, StaysWhileAnotherExpertHasTheHole) {
  auto model = accepted();
  model.experts.push_back(model.experts[0]);
  model.experts[1].id = "S5";
  const auto ways = closeHole(model, "S4", holeOf(model));
  ASSERT_EQ(ways.size(), 3);
  EXPECT_EQ(ways[0].first, "Stretch S4's nasopharynx over the gap");
  EXPECT_EQ(must(ways[0].second).model.accepted_holes, Names{kHole});
}

/// A trapezoid to 2 mm, a Gaussian from 3.0698 mm on: the trapezoid falls where the Gaussian rises, to its mean.
TEST(HoleFixes, ATermIsStretchedToAGaussianAndNotOverIt) {
  fuzzy::ForceModel model = support::s4AsPrinted();
  auto& depth = model.inputs[2];
  const double end = depth.max;
  depth.terms = {{"first", "", fuzzy::Shape::kTrapezoid, {0, 0, 1, 2}},
                 {"narrow", "", fuzzy::Shape::kGaussian, {5, 0.05}},
                 {"last", "", fuzzy::Shape::kTrapezoid, {6, 7, end, end}}};
  model.experts[0].rules = {
      {{{"depth", "first"}}, "small"}, {{{"depth", "narrow"}}, "medium"}, {{{"depth", "last"}}, "large"}};
  model.experts[0].overrides.clear();
  const auto hole = holeOf(model);
  EXPECT_EQ(analysis::describe(hole, model), "depth 2 to 3.0698 mm");
  const auto ways = closeHole(model, "S4", hole);
  ASSERT_EQ(ways.size(), 3);
  EXPECT_EQ(ways[0].first, "Stretch first over the gap");
  const auto points = must(ways[0].second).model.inputs[2].terms[0].points;
  EXPECT_NEAR(points[2], 5 - 1.9302, 1e-4);
  EXPECT_EQ(points[3], 5);
}

TEST(HoleAcceptance, OfferedWaysStayFewWhereEveryExpertHasAListOfHisOwn) {
  auto model = support::s4AsPrinted();
  for (int i = 0; i < 20; ++i) {
    model.experts.push_back(model.experts[0]);
    model.experts.back().id = "E" + std::to_string(i);
    model.experts.back().overrides = {{"depth", model.inputs[2].terms}};
  }
  const auto ways = closeHole(model, "", holeOf(model));
  EXPECT_GE(ways.size(), 3);
  EXPECT_LE(ways.size(), kMostStretches + 2);
}

}  // namespace
}  // namespace tactus::editing
