#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/analysis/lint.h"
#include "core/base/random.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;
using fuzzy::Shape;

constexpr std::size_t kPlenty = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kFirst = 0;

// Beside the hole the depth term is at a strength near 0, so every active output term is a bar over its support. The
// largest force: lubrication poor and speed fast give very_large (.7 to 1.1) and a flexed neck in the laryngopharynx
// large (.6 to .8), together a bar on [.6, 1.1] with its centroid at .85.
TEST(JumpToDefault, AtTheOropharynxOfTableA2) {
  const ForceModel model = support::s4AsPrinted();
  const auto compiled = fuzzy::compile(model);
  ForceProbe probe(model, *compiled, kPlenty);
  const auto holes = coverage(model, std::span(&kFirst, 1)).holes;
  ASSERT_EQ(holes.size(), 1);
  const auto jump = jumpToDefault(probe, holes[0], std::nullopt, 1000);
  ASSERT_TRUE(jump.has_value());
  EXPECT_NEAR(jump->newtons, .85, 1e-9);
  EXPECT_EQ(jump->inside[2], 138);
  EXPECT_EQ(jump->outside[2], std::nextafter(138.0, 200.0));
}

// A knows x up to 3 and says small (.35 N alone), B always says large (.7 N): the mean goes from .525 to .7 at 3.
TEST(JumpOfMean, IsTheShareOfTheExpertWhoLeaves) {
  ForceModel model = support::ngtVariables();
  model.inputs = {
      {"x",
       "x",
       "1",
       0,
       10,
       {{"low", "low", Shape::kTrapezoid, {0, 0, 3, 3}}, {"any", "any", Shape::kTrapezoid, {0, 0, 10, 10}}}}};
  model.experts = {{"A", "A", 1, {}, {{{{"x", "low"}}, "small"}}}, {"B", "B", 1, {}, {{{{"x", "any"}}, "large"}}}};
  const auto compiled = fuzzy::compile(model);
  ForceProbe probe(model, *compiled, kPlenty);
  const auto holes = coverage(model, std::span(&kFirst, 1)).holes;
  ASSERT_EQ(holes.size(), 1);
  const auto jump = jumpOfMean(probe, holes[0], 0, 10);
  ASSERT_TRUE(jump.has_value());
  EXPECT_NEAR(jump->newtons, .175, 1e-12);
  EXPECT_EQ(jump->outside[0], 3) << "a vertical edge belongs to the term";
  EXPECT_EQ(jump->inside[0], std::nextafter(3.0, 4.0));
  model.experts.pop_back();
  const auto alone = fuzzy::compile(model);
  ForceProbe lonely(model, *alone, kPlenty);
  EXPECT_FALSE(jumpOfMean(lonely, holes[0], 0, 10).has_value()) << "no expert continues";
}

int apart(const BoundaryJump& jump) {
  int count = 0;
  for (std::size_t i = 0; i < jump.inside.size(); ++i) count += jump.inside[i] == jump.outside[i] ? 0 : 1;
  return count;
}

TEST(BoundaryJumps, AreWhatDirectEvaluationGives) {
  base::Random random(41);
  int jumps = 0;
  for (int m = 0; m < 300; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    const ForceModel model = support::randomModel(random, {});
    const auto compiled = fuzzy::compile(model);
    ForceProbe probe(model, *compiled, kPlenty);
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      const auto holes = coverage(model, std::span(&e, 1)).holes;
      for (std::size_t h = 0; h < std::min<std::size_t>(holes.size(), 8); ++h) {
        const auto& hole = holes[h];
        if (const auto jump = jumpToDefault(probe, hole, e, 10)) {
          ASSERT_EQ(apart(*jump), 1);
          ASSERT_FALSE(compiled->evaluateExpert(e, jump->inside).fired);
          ASSERT_TRUE(compiled->evaluateExpert(e, jump->outside).fired);
          ASSERT_EQ(jump->newtons,
                    std::abs(compiled->evaluateExpert(e, jump->outside).force_n - model.default_force_n));
        }
        const auto jump = jumpOfMean(probe, hole, e, 10);
        if (!jump) continue;
        ++jumps;
        ASSERT_TRUE(compiled->evaluate(jump->inside).fired);
        ASSERT_FALSE(compiled->evaluateExpert(e, jump->inside).fired);
        ASSERT_TRUE(compiled->evaluateExpert(e, jump->outside).fired);
        const double direct = compiled->evaluate(jump->outside).force_n - compiled->evaluate(jump->inside).force_n;
        ASSERT_EQ(jump->newtons, std::abs(direct));
      }
    }
  }
  EXPECT_GT(jumps, 100);
}

TEST(ForceProbe, StopsWhenItsAllowanceIsSpent) {
  const ForceModel model = support::s4AsPrinted();
  const auto compiled = fuzzy::compile(model);
  ForceProbe probe(model, *compiled, 1);
  const auto holes = coverage(model, std::span(&kFirst, 1)).holes;
  EXPECT_TRUE(jumpToDefault(probe, holes[0], 0, 1000).has_value() || !probe.affords());
  EXPECT_FALSE(probe.affords());
}

}  // namespace
}  // namespace tactus::analysis
