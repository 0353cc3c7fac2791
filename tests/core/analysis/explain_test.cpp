#include "core/analysis/explain.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/base/random.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;

Explanation explained(const ForceModel& model, const std::vector<double>& point) {
  const auto compiled = fuzzy::compile(model);
  EXPECT_TRUE(compiled.has_value());
  auto out = explain(model, *compiled, point);
  EXPECT_TRUE(out.has_value());
  return *out;
}

double fourUlp(double x) { return 4 * (std::nextafter(std::abs(x), 1e300) - std::abs(x)); }

// S4 at well lubricated, medium flexion, slow, in the nasal cavity: three rules fire fully, all for very_small; by hand
// the centroid of (0, 0, .2, .3) is (.2 * .1 + .05 * (.2 + .1 / 3)) / .25 = .0316667 / .25.
TEST(Explain, AFullyMetPointOfS4) {
  const ForceModel model = support::s4AsPrinted();
  const auto result = explained(model, {1, 45, 30, 30});
  const auto& s4 = result.experts.at(0);
  EXPECT_NEAR(result.force_n, 0.0316667 / 0.25, 2e-7);
  EXPECT_TRUE(result.fired);
  EXPECT_FALSE(result.is_default);
  EXPECT_EQ(s4.memberships[0][2].term, "well");
  EXPECT_EQ(s4.memberships[0][2].membership, 1);
  EXPECT_EQ(s4.memberships[2][0].membership, 1);
  EXPECT_EQ(s4.memberships[2][1].membership, 0);
  EXPECT_EQ(s4.output_terms[0].strength, 1);
  EXPECT_EQ(s4.output_terms[0].winning_rule, 0) << "the first of three equal ones";
  EXPECT_EQ(s4.output_terms[0].set, (Polyline{{0, 1}, {.2, 1}, {.3, 0}}));
  EXPECT_EQ(s4.aggregated, s4.output_terms[0].set);
  int fired = 0;
  int winners = 0;
  for (const auto& rule : s4.rules) {
    fired += rule.strength > 0 ? 1 : 0;
    winners += rule.wins ? 1 : 0;
  }
  EXPECT_EQ(fired, 3);
  EXPECT_EQ(winners, 1);
  EXPECT_EQ(s4.weight_share, 1);
  EXPECT_EQ(s4.contribution_n, result.force_n);
}

// At depth 70 the nasal cavity and the nasopharynx are both at (80 - 70) / 20 = .5. With lubrication .5, flexion 45 and
// speed 82 (slow (100 - 82) / 36 = .5, medium (82 - 64) / 36 = .5) every firing rule has the strength .5.
TEST(Explain, StrengthsBetweenTwoRegions) {
  const auto result = explained(support::s4AsPrinted(), {.5, 45, 70, 82});
  const auto& s4 = result.experts.at(0);
  const auto& rule = s4.rules[5];  // lubrication medium, nasal cavity
  EXPECT_EQ(rule.memberships, (std::vector<double>{1, .5}));
  EXPECT_EQ(rule.smallest_condition, 1);
  EXPECT_EQ(rule.strength, .5);
  // Cut at .5, very_small, small, medium and large cover [0, .8]: a plateau of .5 to .75, as each ramp meets its
  // neighbor's at .5, and then down to 0.
  EXPECT_NEAR(s4.aggregated.front().height, .5, 1e-15);
  EXPECT_NEAR(s4.aggregated.back().x, .8, 1e-15);
  EXPECT_EQ(s4.aggregated.back().height, 0);
  // Area .375 + .0125; moment .375 * .375 + .0125 * (.75 + .05 / 3) = .15020833.
  EXPECT_NEAR(centroid(s4.aggregated), .15020833333333 / .3875, 1e-12);
  EXPECT_NEAR(result.force_n, .15020833333333 / .3875, 1e-12);
}

TEST(Explain, InputsAreClampedAndNamed) {
  const auto result = explained(support::s4AsPrinted(), {1.5, 45, -3, 30});
  EXPECT_EQ(result.inputs[0].given, 1.5);
  EXPECT_EQ(result.inputs[0].value, 1);
  EXPECT_EQ(result.inputs[2].value, 0);
  EXPECT_EQ(result.inputs[2].id, "depth");
}

TEST(Explain, WhereEveryoneAbstainsTheForceIsTheDefault) {
  ForceModel model = support::s4AsPrinted();
  model.default_force_n = 0.25;
  const auto result = explained(model, {1, 60, 130, 50});
  EXPECT_TRUE(result.is_default);
  EXPECT_EQ(result.force_n, 0.25);
  EXPECT_TRUE(result.experts[0].abstains);
  EXPECT_EQ(result.experts[0].weight_share, 0);
  EXPECT_TRUE(result.experts[0].aggregated.empty());
}

TEST(Explain, ANumberThatIsNoneIsRefused) {
  const ForceModel model = support::s4AsPrinted();
  const auto compiled = fuzzy::compile(model);
  const std::vector<double> bad = {1, std::numeric_limits<double>::quiet_NaN(), 3, 4};
  EXPECT_FALSE(explain(model, *compiled, bad).has_value());
  EXPECT_FALSE(explain(model, *compiled, std::vector<double>{1, 2}).has_value());
}

void compareWithCompiled(const ForceModel& model, const std::vector<double>& point, bool polylines) {
  const auto compiled = fuzzy::compile(model);
  const auto result = *explain(model, *compiled, point);
  const auto force = compiled->evaluate(point);
  ASSERT_EQ(result.fired, force.fired);
  ASSERT_EQ(result.force_n, force.force_n);
  double sum = 0;
  double size = 0;
  double shares = 0;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const auto& expert = result.experts[e];
    std::vector<double> strengths(expert.output_terms.size());
    ASSERT_EQ(compiled->strengths(e, point, strengths), !expert.abstains);
    for (std::size_t t = 0; t < strengths.size(); ++t) {
      ASSERT_NEAR(expert.output_terms[t].strength, strengths[t], fourUlp(strengths[t]));
      const auto winner = expert.output_terms[t].winning_rule;
      if (winner) {
        ASSERT_EQ(expert.rules[*winner].strength, expert.output_terms[t].strength);
      }
    }
    ASSERT_EQ(expert.force_n, compiled->evaluateExpert(e, point).force_n);
    sum += expert.contribution_n;
    size += std::abs(expert.contribution_n);
    shares += expert.weight_share;
    // The vertices of the polylines are doubles: 1e-12 of the range covers their rounding in ordinary models.
    const double range = model.output.max - model.output.min;
    if (polylines && !expert.abstains) {
      ASSERT_NEAR(centroid(expert.aggregated), expert.force_n, expert.sampled ? 2e-3 * range : 1e-12 * range);
      ASSERT_GE(expert.aggregated.front().x, model.output.min);
      ASSERT_LE(expert.aggregated.back().x, model.output.max);
    }
  }
  if (!force.fired) return;
  // The mean is taken from the lower end of the universe on, so its rounding is that of the largest position.
  const double largest = std::max({size, std::abs(model.output.min), std::abs(model.output.max)});
  ASSERT_NEAR(sum, force.force_n, 1e-15 * largest);
  ASSERT_NEAR(shares, 1, 1e-15);
}

TEST(Explain, AgreesWithTheCompiledModelOnRandomModels) {
  base::Random random(11);
  for (int m = 0; m < 800; ++m) {
    const bool adversarial = m % 2 == 1;
    ForceModel model = support::randomModel(random, {.gaussians = m % 4 == 2, .adversarial = adversarial});
    if (m % 8 == 0) support::takeExtremeWeights(random, model);
    for (int p = 0; p < 4; ++p) {
      SCOPED_TRACE("model " + std::to_string(m) + ", point " + std::to_string(p));
      compareWithCompiled(model, support::randomPoint(random, model), !adversarial);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(Polyline, TheEnvelopeHasAVertexAtTheCrossing) {
  const Polyline falling = {{0, 1}, {2, 0}};
  const Polyline rising = {{1, 0}, {3, 1}};
  // 1 - x / 2 = (x - 1) / 2 at x = 1.5.
  const std::vector<Polyline> sets = {falling, rising};
  EXPECT_EQ(upperEnvelope(sets), (Polyline{{0, 1}, {1, .5}, {1.5, .25}, {2, .5}, {3, 1}}));
}

TEST(Polyline, AGapBetweenSetsIsZero) {
  const std::vector<Polyline> sets = {{{0, 1}, {1, 1}}, {{2, 1}, {3, 1}}};
  EXPECT_EQ(upperEnvelope(sets), (Polyline{{0, 1}, {1, 1}, {1, 0}, {2, 0}, {2, 1}, {3, 1}}));
  EXPECT_DOUBLE_EQ(centroid(upperEnvelope(sets)), 1.5);
}

}  // namespace
}  // namespace tactus::analysis
