#include "app/editing/edit_impact.h"

#include <gtest/gtest.h>

#include "app/editing/rule_edits.h"
#include "app/editing/term_edits.h"
#include "core/analysis/force_difference.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

using Points = std::vector<double>;

EditImpact impactOf(const fuzzy::ForceModel& before, const Edit& edit) {
  return editImpact(before, fuzzy::compile(before).value(), edit.model, edit.compiled);
}

/// One rule; the centroids of the output terms are 0.1 and 0.6 N whatever the strength.
fuzzy::ForceModel oneRule() {
  fuzzy::ForceModel model;
  model.name = "one rule";
  model.inputs = {{"x", "X", "mm", 0, 10, {{"any", "", fuzzy::Shape::kTrapezoid, {0, 0, 6, 8}}}}};
  model.output = {
      "force",
      "Force",
      "N",
      0,
      1,
      {{"low", "", fuzzy::Shape::kTriangle, {0, 0.1, 0.2}}, {"high", "", fuzzy::Shape::kTriangle, {0.5, 0.6, 0.7}}}};
  model.experts = {{"E", "", 1, {}, {{{{"x", "any"}}, "low"}}}};
  return model;
}

TEST(EditImpact, OfOneRuleByHand) {
  const auto model = oneRule();
  const auto impact = impactOf(model, must(setConsequent(model, "E", 0, "high")));
  EXPECT_NEAR(impact.largest_n, 0.5, 1e-15);
  EXPECT_NEAR(impact.before_n, 0.1, 1e-15);
  EXPECT_NEAR(impact.after_n, 0.6, 1e-15);
  // Around 0.1 N: sqrt(0.04^2 + 0.012^2) = 0.0417612 N.
  EXPECT_NEAR(impact.noticeable, 0.5 / 0.0417612, 1e-3);
  EXPECT_EQ(impact.opened + impact.closed, 0);
}

TEST(EditImpact, AHoleThatOpensIsCountedNotCompared) {
  const auto model = oneRule();
  const auto impact = impactOf(model, must(moveEdge(model, {{"x", ""}, "any"}, Side::kRight, -5)));
  EXPECT_NEAR(impact.largest_n, 0, 1e-15);  // 0.1 N at any strength, but for rounding
  EXPECT_GT(impact.opened, 0);
  EXPECT_EQ(impact.closed, 0);
}

/// exp(-u^2 / 2) is 0 in doubles from u = 38.604 on: a narrow Gaussian changes nothing beyond 38.604 sigma.
TEST(EditImpact, AGaussianChangesNoMoreThanItCovers) {
  auto model = oneRule();
  model.inputs[0].terms.push_back({"narrow", "", fuzzy::Shape::kGaussian, {5, 0.05}});
  model.experts[0].rules.push_back({{{"x", "narrow"}}, "high"});
  auto moved = model;
  moved.inputs[0].terms[1].points = {5.5, 0.05};
  const auto region = changedRegion(model, moved);
  ASSERT_EQ(region.size(), 1);
  EXPECT_NEAR(region[0].low, 5 - 1.9302, 1e-4);
  EXPECT_NEAR(region[0].high, 5.5 + 1.9302, 1e-4);
  EXPECT_FALSE(region[0].whole_universe);
}

TEST(EditImpact, OnlyTheChangedRegionIsLookedAt) {
  const auto model = support::s4AsPrinted();
  const auto moved = must(moveVertex(model, {kDepth, "nasopharynx", 3}, 132));
  const auto region = changedRegion(model, moved.model);
  ASSERT_EQ(region.size(), 4);
  EXPECT_TRUE(region[0].whole_universe);
  EXPECT_EQ(region[2], (analysis::InputRange{"depth", 60, 132, true, true, false}));
  const auto rule = changedRegion(model, must(setConsequent(model, "S4", 3, "large")).model);
  EXPECT_EQ(rule[0], (analysis::InputRange{"lubrication", 0.6, 1, true, true, false}));
  EXPECT_EQ(rule[2], (analysis::InputRange{"depth", 185, 460, true, true, false}));
  auto words = model;
  words.name = "another name";
  words.inputs[0].terms[0].label = "Dry";
  EXPECT_TRUE(changedRegion(model, words).empty());
  EXPECT_EQ(impactOf(model, *finished(words, "")).points, 0);
}

TEST(EditImpact, FindsAboutWhatTheLongSearchFinds) {
  const auto model = support::s4FiveRegions();
  const auto compiled = fuzzy::compile(model).value();
  const std::vector<Edit> edits = {
      must(moveVertex(model, {kDepth, "nasopharynx", 3}, 140)),
      must(moveTerm(model, {{"speed", ""}, "medium"}, 25, {true, {}})),
      must(moveVertex(model, {kForce, "medium", 0}, 0.3)),
      must(setConsequent(model, "S4", 20, "very_large")),
      must(setRuleWeight(model, "S4", 40, 0.3)),
  };
  for (const auto& edit : edits) {
    const auto long_search = analysis::forceDifference(model, compiled, edit.model, edit.compiled);
    // Both are samples; the short one looks closer at the region that changed.
    EXPECT_GE(impactOf(model, edit).largest_n, 0.95 * long_search.largest_n) << edit.label;
    EXPECT_GT(long_search.largest_n, 0) << edit.label;
  }
}

TEST(ModelGhost, HasBothCurves) {
  const auto model = oneRule();
  const auto edit = must(setConsequent(model, "E", 0, "high"));
  const ModelGhost ghost(model, fuzzy::compile(model).value(), edit.model, edit.compiled);
  ASSERT_EQ(ghost.region().size(), 1);
  EXPECT_EQ(ghost.region()[0].high, 8);
  const auto curve = ghost.curve(0, Points{0}, 11).value();
  ASSERT_EQ(curve.points.size(), 11);
  EXPECT_EQ(curve.points[10].at, 10);
  EXPECT_FALSE(curve.points[9].before_fired);
  EXPECT_NEAR(curve.points[3].before_n, 0.1, 1e-15);
  EXPECT_NEAR(curve.points[3].after_n, 0.6, 1e-15);
  EXPECT_NEAR(curve.largest_n, 0.5, 1e-15);
  EXPECT_NEAR(ghost.difference().largest_n, 0.5, 1e-15);
  EXPECT_FALSE(ghost.curve(1, Points{0}, 11));
  EXPECT_FALSE(ghost.curve(0, Points{0}, 1));
}

}  // namespace
}  // namespace tactus::editing
