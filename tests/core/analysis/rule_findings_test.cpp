#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/analysis/rule_table.h"
#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;

std::vector<RulePair> redundantOf(const ForceModel& model, std::size_t expert = 0) {
  return redundantRules(resolveRules(model, model.experts[expert]), model.inputs.size());
}

TEST(RedundantRules, NeedFewerConditionsTheSameConsequentAndTheWeight) {
  ForceModel model = support::ngtVariables();
  model.experts = {{"A",
                    "A",
                    1,
                    {},
                    {{{{"speed", "fast"}}, "large", .8}, {{{"depth", "stomach"}, {"speed", "fast"}}, "large", .8}}}};
  ASSERT_EQ(redundantOf(model).size(), 1);
  EXPECT_EQ(redundantOf(model)[0].rule, 1);
  EXPECT_EQ(redundantOf(model)[0].other, 0);
  auto& rules = model.experts[0].rules;
  rules[1].weight = .9;
  EXPECT_TRUE(redundantOf(model).empty()) << "the longer rule is stronger";
  rules[1].weight = .5;
  EXPECT_EQ(redundantOf(model).size(), 1);
  rules[1].then = "small";
  EXPECT_TRUE(redundantOf(model).empty());
  rules[1].then = "large";
  rules[0].enabled = false;
  EXPECT_TRUE(redundantOf(model).empty());
}

TEST(RedundantRules, TableA2HasNone) { EXPECT_TRUE(redundantOf(support::s4AsPrinted()).empty()); }

// Firing strengths only grow with fewer conditions, in floating point too, so those of the output terms are equal to
// the last bit.
TEST(RedundantRules, RemovingThemAllChangesNoForce) {
  base::Random random(31);
  int removed = 0;
  for (int m = 0; m < 2000; ++m) {
    const ForceModel model = support::randomModel(random, {.gaussians = m % 3 == 0});
    ForceModel shorter = model;
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      const auto redundant = redundantOf(model, e);
      for (auto it = redundant.rbegin(); it != redundant.rend(); ++it) {
        auto& rules = shorter.experts[e].rules;
        rules.erase(rules.begin() + static_cast<std::ptrdiff_t>(it->rule));
        ++removed;
      }
    }
    const auto before = fuzzy::compile(model);
    const auto after = fuzzy::compile(shorter);
    for (int p = 0; p < 10; ++p) {
      const auto point = support::randomPoint(random, model);
      for (std::size_t e = 0; e < model.experts.size(); ++e) {
        std::array<double, fuzzy::kMostTerms> with{};
        std::array<double, fuzzy::kMostTerms> without{};
        ASSERT_EQ(before->strengths(e, point, with), after->strengths(e, point, without));
        ASSERT_EQ(with, without);
      }
      ASSERT_EQ(before->evaluate(point).fired, after->evaluate(point).fired);
      // Equal strengths may still take different ways through the evaluator, which agree to 4 ulp of a position.
      const double largest = std::max(std::abs(model.output.min), std::abs(model.output.max));
      const double bound = 4 * std::numeric_limits<double>::epsilon() * largest;
      ASSERT_NEAR(before->evaluate(point).force_n, after->evaluate(point).force_n, bound);
    }
  }
  EXPECT_GT(removed, 100);
}

TEST(Conflicts, AreRulesWithTheSameConditionsInAnyOrder) {
  ForceModel model = support::ngtVariables();
  model.experts = {{"A",
                    "A",
                    1,
                    {},
                    {{{{"speed", "fast"}, {"depth", "stomach"}}, "large"},
                     {{{"depth", "stomach"}, {"speed", "fast"}}, "small"},
                     {{{"depth", "stomach"}}, "small"}}}};
  const auto found = conflicts(resolveRules(model, model.experts[0]));
  ASSERT_EQ(found.size(), 1);
  EXPECT_EQ(found[0].rule, 1);
  EXPECT_EQ(found[0].other, 0);
}

// Symmetric terms have their centroid in the middle at any strength; very_small alone: .0316667 / .25.
TEST(ForceOfTerm, IsTheCentroidOfTheTermAlone) {
  const ForceModel model = support::ngtVariables();
  EXPECT_NEAR(forceOfTerm(model, model.output.terms[1], 1), .35, 1e-15);
  EXPECT_NEAR(forceOfTerm(model, model.output.terms[3], .3), .7, 1e-15);
  EXPECT_NEAR(forceOfTerm(model, model.output.terms[0], 1), .19 / 6 / .25, 1e-15);
}

}  // namespace
}  // namespace tactus::analysis
