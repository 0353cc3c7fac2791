#include "core/analysis/coverage.h"

#include <gtest/gtest.h>
#include <numeric>

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

}  // namespace
}  // namespace tactus::analysis
