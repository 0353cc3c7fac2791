// The look-up table against the evaluator: what it promises holds everywhere in the box of the inputs.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "app/bundle/bounded_table.h"
#include "core/base/random.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::bundle {
namespace {

using Point = std::vector<double>;

fuzzy::CompiledModel compiled(const fuzzy::ForceModel& model) { return fuzzy::compile(model).value(); }

/// One rule for the whole universe of x.
fuzzy::ForceModel constantModel() {
  fuzzy::ForceModel model;
  model.inputs.push_back({"x", "", "mm", 0, 1, {{"all", "", fuzzy::Shape::kTrapezoid, {0, 0, 1, 1}}}});
  model.output = {"force", "", "N", 0, 1, {{"half", "", fuzzy::Shape::kTriangle, {0, 0.5, 1}}}};
  fuzzy::Expert expert;
  expert.id = "E";
  expert.rules.push_back({{{"x", "all"}}, "half"});
  model.experts.push_back(expert);
  return model;
}

TEST(ForceTable, IsTheForceAtItsNodesAndLinearBetween) {
  const ForceTable table = forceTable(compiled(constantModel()), {{0, .25, .5, 1}});
  EXPECT_NEAR(table.force(std::vector{0.333}), 0.5, 1e-15);
  EXPECT_NEAR(table.force(std::vector{-4.0}), 0.5, 1e-15);

  const auto ngt = support::s4FiveRegions();
  const ForceTable grid = forceTable(compiled(ngt), vertexLines(ngt, kMostNodes));
  const auto again = parseTable(ngt, formatTable(ngt, grid), "table.csv");
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(again->force_n, grid.force_n);
  EXPECT_EQ(again->lines, grid.lines);
  for (std::size_t i = 0; i < 50; ++i) {
    Point node;
    for (const auto& line : grid.lines) node.push_back(line[i * 7 % line.size()]);
    EXPECT_NEAR(grid.force(node), compiled(ngt).evaluate(node).force_n, 1e-15);
  }
}

// Two ramps x and y, one word for both high and another for the rest: between them min(x, y), whose largest distance
// from the bilinear x y is 1/4, at 1/2. Words with as much area on both sides of their middles make the force nearly a
// line of the strength, so the bound must lie near that of the kink: sampled at 1000 x 1000 points.
TEST(TableBound, OfAKinkIsCloseToWhatIsThere) {
  auto model = constantModel();
  const std::vector<fuzzy::Term> ramps = {{"low", "", fuzzy::Shape::kTrapezoid, {0, 0, 0, 1}},
                                          {"high", "", fuzzy::Shape::kTrapezoid, {0, 1, 1, 1}}};
  model.inputs = {{"x", "", "mm", 0, 1, ramps}, {"y", "", "mm", 0, 1, ramps}};
  model.output.terms = {{"small", "", fuzzy::Shape::kTriangle, {0, 0.25, 0.5}},
                        {"large", "", fuzzy::Shape::kTriangle, {0.5, 0.75, 1}}};
  model.experts[0].rules = {
      {{{"x", "high"}, {"y", "high"}}, "large"}, {{{"x", "low"}}, "small"}, {{{"y", "low"}}, "small"}};
  const auto evaluator = compiled(model);
  const ForceTable table = forceTable(evaluator, vertexLines(model, kMostNodes));
  const TableBound bound = tableBound(model, evaluator, table, 0.001);
  double worst_n = 0;
  for (int i = 0; i <= 1000; ++i) {
    for (int j = 0; j <= 1000; ++j) {
      const Point at = {i / 1000.0, j / 1000.0};
      worst_n = std::max(worst_n, std::abs(table.force(at) - evaluator.evaluate(at).force_n));
    }
  }
  EXPECT_FALSE(bound.jumps);
  EXPECT_GT(worst_n, 0.05);
  EXPECT_GE(bound.bound_n, worst_n - 1e-12);
  EXPECT_LE(bound.bound_n, 1.05 * worst_n);
  EXPECT_LE(bound.found_n, worst_n + 1e-4);
}

TEST(TableBound, HoldsAtEveryPointOfRandomModels) {
  base::Random random(61);
  int jumps = 0;
  int smooth = 0;
  for (int m = 0; m < 60; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    auto model = support::randomModel(random, {.gaussians = m % 3 == 0, .adversarial = false});
    if (model.inputs.size() > 2) continue;
    const double range_n = model.output.max - model.output.min;
    const auto evaluator = compiled(model);
    const BoundedTable made = boundedTable(model, evaluator, 0.05 * range_n, 2'000);
    (made.bound.jumps ? jumps : smooth) += 1;
    for (int p = 0; p < 3'000; ++p) {
      // Points on a vertex belong to one side of a jump.
      Point at;
      for (const auto& input : model.inputs) at.push_back(random.uniform(input.min, input.max));
      ASSERT_LE(std::abs(made.table.force(at) - evaluator.evaluate(at).force_n), made.bound.bound_n + 1e-9 * range_n);
    }
  }
  EXPECT_GT(jumps, 5);
  EXPECT_GT(smooth, 5);
}

TEST(BoundedTable, IsNowhereFurtherOffThanWanted) {
  // S4 with its regions ends at a hole; the rule closes it.
  auto model = support::s4FiveRegions();
  model.experts[0].rules.push_back({{{"lubrication", model.inputs[0].terms[0].id}}, model.output.terms[2].id});
  const auto evaluator = compiled(model);
  const BoundedTable made = boundedTable(model, evaluator, 0.1);
  EXPECT_LE(made.bound.bound_n, made.bound.jumps ? model.output.max : 0.1);
  base::Random random(62);
  double worst_n = 0;
  for (int p = 0; p < 200'000; ++p) {
    Point at;
    for (const auto& input : model.inputs) at.push_back(random.uniform(input.min, input.max));
    worst_n = std::max(worst_n, std::abs(made.table.force(at) - evaluator.evaluate(at).force_n));
  }
  EXPECT_LE(worst_n, made.bound.bound_n);
  EXPECT_GT(worst_n, 0.3 * made.bound.bound_n);
}

TEST(BoundedTable, OfAConstantForceHasOnlyItsEnds) {
  const auto made = boundedTable(constantModel(), compiled(constantModel()));
  EXPECT_EQ(made.table.lines, (std::vector<std::vector<double>>{{0, 1}}));
  EXPECT_LT(made.bound.bound_n, 0.01);
}

}  // namespace
}  // namespace tactus::bundle
