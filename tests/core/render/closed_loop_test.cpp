// The renderer in a loop with simulated hands: what the hand may never feel.
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/haptics/simulated/hand_plan.h"
#include "core/haptics/simulated/virtual_device.h"

#include "tests/core/render/rendered_loop.h"
#include "tests/support/loop_measures.h"

namespace tactus::render {
namespace {

using haptics::HandPlan;
using haptics::SimulatedHand;
using support::Disturbance;
using support::simulateLoop;

struct Scenario {
  std::string name;
  HandPlan plan;
  double duration_s;
  int most_transitions;
  double largest_step_n = 0.03;
  double most_ripple_n = 0.02;
};

HandPlan reversals() { return haptics::swing(15, 0.8); }

/// The limits: 6 transitions in a monotone stroke, 20 in 4 s of reversals; 10 Hz of tremor pass the middle 80 times.
/// A device that is not held springs back at 140 mm/s and swings: three counts a tick are 0.041 N, damping comes
/// beside.
std::vector<Scenario> scenarios() {
  return {{"stroke 0.4 s", haptics::stroke(60, 0.4), 0.9, 6},
          {"stroke 0.8 s", haptics::stroke(60, 0.8), 1.3, 6},
          {"stroke 2 s", haptics::stroke(60, 2), 2.5, 6},
          {"slow push", haptics::push(5), 4, 6, 0.03, 0.01},
          {"hold with tremor", haptics::both(haptics::swing(0.3, 10), haptics::stroke(5, 1)), 4, 80},
          {"reversals", reversals(), 4, 20},
          {"let go while sliding", haptics::lettingGo(haptics::stroke(60, 0.8), 0.4), 1.3, 10, 0.05}};
}

const SimulatedHand kHands[] = {haptics::kPinch, haptics::kArm, haptics::kFiveParameters};

struct Model {
  ForceAt force_at;
  int more_transitions = 0;
};

/// Model forces that rise, are constant, and fall with speed. The last, -2 N s/m, outweighs the damping of a pinch
/// (1.7 N s/m with the device): stick-slip is then what the model says, and it must stay passive.
std::vector<Model> models() {
  return {{linearForce(0.35, 0.0015)}, {linearForce(0.4, 0)}, {linearForce(0.6, -0.002, 0.2), 7}};
}

// Energy: the delay of one tick and the counts can hide about k count² = 0.0008 mJ; the limit of the design is 0.01 mJ.
// Certificate: sums of some 10^4 terms near 1.
constexpr double kEnergyLimitMj = -0.01;
constexpr double kCertificateRounding = -1e-9;

TEST(ClosedLoop, IsQuietAndPassiveUnderEveryHand) {
  for (const Scenario& scenario : scenarios()) {
    for (const SimulatedHand& hand : kHands) {
      for (const Model& model : models()) {
        SCOPED_TRACE(scenario.name + ", " + std::string(hand.name));
        RenderedLoop loop;
        loop.force_at = model.force_at;
        loop.state.depth_mm = 100;
        const auto ticks = simulateLoop(hand, {}, scenario.plan, scenario.duration_s, loop.servo());
        EXPECT_LE(largestStepN(ticks), scenario.largest_step_n);
        EXPECT_LE(loop.transitions, scenario.most_transitions + model.more_transitions);
        EXPECT_LE(rippleN(ticks), scenario.most_ripple_n);
        EXPECT_GE(lowestEnergyMj(ticks), kEnergyLimitMj);
        EXPECT_GE(loop.lowest_certificate, kCertificateRounding);
      }
    }
  }
}

TEST(ClosedLoop, SurvivesDroppedTicksAndStalls) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    for (const Scenario& scenario : scenarios()) {
      const SimulatedHand& hand = kHands[seed % 3];
      SCOPED_TRACE(scenario.name + ", " + std::string(hand.name) + ", seed " + std::to_string(seed));
      RenderedLoop loop;
      loop.state.depth_mm = 100;
      const Disturbance disturbance{0.001, 2, seed};
      const auto ticks = simulateLoop(hand, {}, scenario.plan, scenario.duration_s, loop.servo(), disturbance);
      for (const auto& tick : ticks) ASSERT_LE(std::abs(tick.force_n), loop.settings.force_cap_n);
      EXPECT_LE(loop.transitions, scenario.most_transitions);
      // A stall holds the force while the hand moves on: up to 0.5 N over 5 ms at 200 mm/s.
      EXPECT_GE(lowestEnergyMj(ticks), -0.5);
      EXPECT_GE(loop.lowest_certificate, kCertificateRounding);
    }
  }
}

TEST(ClosedLoop, NoLimitCycleOnceTheHandRests) {
  for (const SimulatedHand& hand : {haptics::kPinch, haptics::kArm}) {
    RenderedLoop loop;
    const auto ticks = simulateLoop(hand, {}, haptics::stroke(60, 0.8), 2.5, loop.servo());
    EXPECT_LT(lastSpeedMmS(ticks), 5) << hand.name;
  }
}

TEST(ClosedLoop, PinchedStrokeCountsMostOfThePlan) {
  RenderedLoop loop;
  simulateLoop(haptics::kPinch, {}, haptics::stroke(60, 0.8), 1.3, loop.servo());
  EXPECT_NEAR(loop.state.depth_mm, 60, 0.15 * 60);
}

TEST(ClosedLoop, SlowPushEndsWhereStaticsPutsIt) {
  RenderedLoop loop;
  simulateLoop(haptics::kPinch, {}, haptics::push(5), 4, loop.servo());
  // The hand's spring of 0.1 N/mm carries friction, device friction and device damping; the tube's spring the friction.
  const double friction_n = 0.35 + 0.0015 * 5;
  const double hand_mm = (friction_n + 0.05 + 0.2e-3 * 5) / 0.1;
  EXPECT_NEAR(loop.state.depth_mm, 20 - hand_mm - friction_n / 0.25, 0.055);  // one count
}

TEST(ClosedLoop, SixHundredMillimetresInTenStrokes) {
  const double stroke_s = 1.2;
  const double back_s = 0.8;
  RenderedLoop loop;
  loop.enabled = [=](double time_s) { return std::fmod(time_s, stroke_s + back_s) < stroke_s; };
  // Pushes for 0.8 s, holds, lets the tube go, and comes back for the next stroke.
  const HandPlan plan = haptics::strokes({.count = 10, .length_mm = 60, .settle_s = 0, .hold_s = 0.4});
  const auto ticks = simulateLoop(haptics::kPinch, {}, plan, 10 * (stroke_s + back_s), loop.servo());
  EXPECT_EQ(loop.state.stroke.number, 10U);
  EXPECT_NEAR(loop.state.depth_mm, 600, 0.15 * 600);
  EXPECT_LE(largestStepN(ticks), 0.03);
  EXPECT_GE(lowestEnergyMj(ticks), kEnergyLimitMj);
  // No inference while released, one a tick at most otherwise, none while stuck.
  EXPECT_LT(loop.questions, 10 * 1000 * stroke_s);
}

TEST(ClosedLoop, ReleaseUnderForceIsOverAfterThirtyMilliseconds) {
  RenderedLoop loop;
  loop.enabled = [](double time_s) { return time_s < 0.5; };
  const auto ticks = simulateLoop(haptics::kPinch, {}, haptics::stroke(60, 0.8), 1.0, loop.servo());
  EXPECT_GT(ticks[500].force_n, 0.3);
  for (std::size_t i = 532; i < ticks.size(); ++i) ASSERT_EQ(ticks[i].force_n, 0) << i;  // one tick of delay
}

TEST(ClosedLoop, PressAtSpeedDoesNotGrab) {
  RenderedLoop loop;
  loop.enabled = [](double time_s) { return time_s > 0.25; };  // at 220 mm/s
  const auto ticks = simulateLoop(haptics::kPinch, {}, haptics::stroke(60, 0.5), 1.0, loop.servo());
  EXPECT_LE(largestStepN(ticks), 0.25 * 5 * 0.055 + 0.01);  // five counts a tick at 225 mm/s, damping beside
  EXPECT_GE(lowestEnergyMj(ticks), kEnergyLimitMj);
}

TEST(ClosedLoop, SameRunSameBits) {
  std::vector<support::LoopTick> runs[2];
  for (auto& run : runs) {
    RenderedLoop loop;
    run = simulateLoop(haptics::kArm, {}, reversals(), 2, loop.servo(), {0.001, 2, 7});
  }
  for (std::size_t i = 0; i < runs[0].size(); ++i) {
    ASSERT_EQ(runs[0][i].position_mm, runs[1][i].position_mm);
    ASSERT_EQ(runs[0][i].force_n, runs[1][i].force_n);
  }
}

}  // namespace
}  // namespace tactus::render
