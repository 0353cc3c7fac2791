// Why the renderer is an elasto-plastic element: the candidates on the same device under the same hand.
//
// The expected numbers are an independent study of the same set-up: device of 45 g, 0.2 N s/m and 0.05 N dry friction,
// counts of 0.055 mm, 1 kHz with one tick of delay, k = 0.25 N/mm, tau = 0.15, F_d = 0.35 + 0.0015 v, pinching hand.
// Two details are inferred, because that study does not state them: 0.3 s of rest before each slow push (without it the
// renderer counts 14.5 mm, as statics demands, not 13.0; with it Karnopp's 640 changes come out as well), and a Karnopp
// that is stuck exactly below a speed (one that leaves by force changes state 20 times, not 640).
#include <gtest/gtest.h>
#include <vector>

#include "core/haptics/simulated/hand_plan.h"

#include "tests/core/render/friction_variants.h"
#include "tests/core/render/rendered_loop.h"
#include "tests/support/loop_measures.h"

namespace tactus::render {
namespace {

using haptics::HandPlan;
using haptics::stroke;
using haptics::swing;
using support::LoopTick;
using support::simulateLoop;

struct Outcome {
  int transitions = 0;
  double step_n = 0;
  double ripple_n = 0;
  double depth_mm = 0;
  double energy_mj = 0;
};

Outcome outcome(const std::vector<LoopTick>& ticks, int transitions, double depth_mm) {
  return {transitions, largestStepN(ticks), rippleN(ticks), depth_mm, lowestEnergyMj(ticks)};
}

HandPlan slowPush() { return haptics::after(0.3, haptics::push(5)); }
HandPlan strokeOf60Mm() { return stroke(60, 0.8); }
HandPlan shakyStroke() { return both(swing(0.3, 10), stroke(5, 1)); }

Outcome rendered(const HandPlan& plan, double duration_s) {
  RenderedLoop loop;
  const auto ticks = simulateLoop(haptics::kPinch, {}, plan, duration_s, loop.servo());
  return outcome(ticks, loop.transitions, loop.state.depth_mm);
}

template <typename V>
Outcome variant(V model, const HandPlan& plan, double duration_s) {
  const auto ticks = simulateLoop(haptics::kPinch, {}, plan, duration_s,
                                  [&](double, double x, double dt_s) { return model.tick(x, dt_s); });
  return outcome(ticks, model.transitions(), model.depthMm());
}

// One count at k = 0.25 N/mm is a step of 0.01375 N; damping and slew add a little.
constexpr double kStepFloorN = 0.0155;

TEST(FrictionComparison, ElastoPlasticSlowPush) {
  const Outcome seen = rendered(slowPush(), 4);
  EXPECT_EQ(seen.transitions, 1);
  EXPECT_LE(seen.step_n, kStepFloorN);
  EXPECT_NEAR(seen.ripple_n, 0.0020, 0.0010);  // the study does not name its 30 Hz filter
  EXPECT_NEAR(seen.depth_mm, 13.0, 0.055);     // one count
}

TEST(FrictionComparison, ElastoPlasticStroke) {
  const Outcome seen = rendered(strokeOf60Mm(), 1.3);
  EXPECT_LE(seen.transitions, 4);
  EXPECT_LE(seen.step_n, kStepFloorN);
  EXPECT_LE(seen.ripple_n, 0.005);
  EXPECT_NEAR(seen.depth_mm, 54.8, 0.055);
}

TEST(FrictionComparison, KarnoppChattersOnRawVelocity) {
  // Each count is 55 mm/s for one tick: 206 and 640 changes of state, steps of F_d(55) = 0.4325 N.
  const Outcome stroke = variant(Karnopp(0), strokeOf60Mm(), 1.3);
  EXPECT_NEAR(stroke.transitions, 206, 10);
  EXPECT_NEAR(stroke.step_n, 0.433, 0.001);
  const Outcome push = variant(Karnopp(0), slowPush(), 4);
  EXPECT_NEAR(push.transitions, 640, 32);
  EXPECT_NEAR(push.step_n, 0.433, 0.001);
}

TEST(FrictionComparison, KarnoppStillChattersAndFeedsEnergyOnFilteredVelocity) {
  const Outcome stroke = variant(Karnopp(25), strokeOf60Mm(), 1.3);
  EXPECT_GT(stroke.transitions, 22);  // half of the 44 of the study: the count hangs on details of the dead band
  EXPECT_NEAR(stroke.step_n, 0.36, 0.01);
  const Outcome shaky = variant(Karnopp(25), shakyStroke(), 4);
  EXPECT_LT(shaky.energy_mj, -0.5);
  EXPECT_GT(rendered(shakyStroke(), 4).energy_mj, -0.01);
}

TEST(FrictionComparison, RestartingAtZeroClicks) {
  // The drop at each stop is F_d(0) = 0.35 N at least, within one tick.
  for (const double damping : {0.0005, -0.0005}) {
    const Outcome stroke = variant(Restart(25, damping), strokeOf60Mm(), 1.3);
    EXPECT_EQ(stroke.transitions, damping > 0 ? 2 : 4);
    EXPECT_NEAR(stroke.step_n, 0.354, 0.006);
    EXPECT_NEAR(stroke.depth_mm, damping > 0 ? 54.6 : 54.3, 0.3);
    EXPECT_GT(variant(Restart(25, damping), slowPush(), 4).step_n, 0.35);
  }
}

TEST(FrictionComparison, PrintedSignSticksMoreOftenAndLosesDepth) {
  const Outcome printed = variant(Restart(25, -0.0005), slowPush(), 4);
  const Outcome resisting = variant(Restart(25, 0.0005), slowPush(), 4);
  EXPECT_GT(printed.transitions, resisting.transitions);
  EXPECT_LT(printed.depth_mm, resisting.depth_mm);
}

TEST(FrictionComparison, CoulombBuzzesAndNeverHolds) {
  const Outcome raw = variant(Coulomb(0), slowPush(), 4);
  EXPECT_GT(raw.transitions, 500);
  EXPECT_GT(raw.ripple_n, 20 * rendered(slowPush(), 4).ripple_n);
  EXPECT_LT(variant(Coulomb(25), shakyStroke(), 4).energy_mj, -0.5);
}

TEST(FrictionComparison, DahlDriftsWhereTheRendererHolds) {
  // A push of 0.2 N, half the friction, with tremor: a stuck tube must not creep.
  const auto leaning = both(swing(0.5, 10), stroke(3, 0.5));
  EXPECT_EQ(rendered(leaning, 4).depth_mm, 0);
  EXPECT_GT(variant(Dahl(25), leaning, 4).depth_mm, 0.2);
}

}  // namespace
}  // namespace tactus::render
