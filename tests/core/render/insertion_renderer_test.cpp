#include "core/render/insertion_renderer.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/render/friction.h"

#include "tests/core/render/scripted_tube.h"

namespace tactus::render {
namespace {

// Rounding of a few hundred additions of numbers near 1.
constexpr double kRounding = 1e-12;

TEST(InsertionRenderer, PressAnchorsWhereTheHandIs) {
  ScriptedTube tube;
  tube.held = false;
  tube.moveTo(40, 200);
  tube.held = true;
  tube.tick(40);
  EXPECT_EQ(tube.state.phase, Phase::kStuck);
  EXPECT_EQ(tube.state.force_n, 0);
  EXPECT_EQ(tube.state.depth_mm, 0);
}

TEST(InsertionRenderer, StuckTubeIsASpring) {
  ScriptedTube tube;
  tube.moveTo(1.5, 150);
  EXPECT_NEAR(tube.state.force_n, 0.25 * 1.5, kRounding);
  EXPECT_EQ(tube.state.depth_mm, 0);
  tube.moveTo(0, 150);
  EXPECT_NEAR(tube.state.force_n, 0, kRounding);
}

TEST(InsertionRenderer, BreaksAwayAtTheStaticForceAndFallsToTheModels) {
  ScriptedTube tube;
  double peak_n = 0;
  double peak_at_mm = 0;
  for (double x = 0; x < 4; x += 0.01) {
    tube.tick(x);
    if (tube.state.force_n > peak_n) peak_at_mm = x;
    peak_n = std::max(peak_n, tube.state.force_n);
  }
  // F_m = 1.15 * 0.4 N, reached after 0.46 / 0.25 mm; one tick moves the hand by 0.01 mm.
  EXPECT_NEAR(peak_n, 0.46, 0.25 * 0.01);
  EXPECT_NEAR(peak_at_mm, 1.84, 0.0101);
  EXPECT_EQ(tube.state.phase, Phase::kSlidingIn);
  // More than 200 ms later exp(-20) of the surplus of 0.06 N is left.
  EXPECT_NEAR(tube.state.force_n, 0.4, 1e-9);
}

TEST(InsertionRenderer, DepthIsWhatTheHandMovesLessTheStretch) {
  ScriptedTube tube;
  tube.state.depth_mm = 100;
  tube.tick(0);
  for (const double x : {30.0, 12.0, 55.0, 54.0, 20.0}) {
    tube.moveTo(x, 300);
    EXPECT_NEAR(tube.state.depth_mm - 100, x - tube.state.stretch_mm, 1e-10);
  }
}

TEST(InsertionRenderer, SmallReturnKeepsSlidingALargerOneSticks) {
  ScriptedTube tube;
  tube.moveTo(10, 300);
  tube.moveTo(9.9, 2);
  EXPECT_EQ(tube.state.phase, Phase::kSlidingIn);
  const double before_n = tube.state.force_n;
  tube.tick(9.87);
  EXPECT_EQ(tube.state.phase, Phase::kStuck);
  EXPECT_NEAR(tube.state.force_n, before_n - 0.25 * 0.03, 1e-9);
}

TEST(InsertionRenderer, WithdrawalMeetsItsShareOfTheFriction) {
  ScriptedTube tube;
  tube.state.depth_mm = 100;
  tube.moveTo(-20, 500);
  EXPECT_EQ(tube.state.phase, Phase::kSlidingOut);
  EXPECT_NEAR(tube.state.force_n, -0.6 * 0.4, 1e-9);
  EXPECT_NEAR(tube.state.depth_mm, 100 - 20 + 0.24 / 0.25, 1e-8);
}

TEST(InsertionRenderer, RestBuildsUpStaticFriction) {
  ScriptedTube tube;
  tube.moveTo(10, 300);
  tube.moveTo(9.5, 10);  // stuck again, without any stiction
  tube.moveTo(9.5, 100);
  double peak_n = 0;
  for (double x = 9.5; x < 10.6; x += 0.05) {
    tube.tick(x);
    peak_n = std::max(peak_n, tube.state.force_n);
  }
  // 100 ms is one time constant; the ticks around it, some 20, add up to a fifth of another.
  EXPECT_GT(peak_n, 0.4 * (1 + 0.15 * (1 - std::exp(-1.0))) - 0.25 * 0.05);
  EXPECT_LT(peak_n, 0.4 * (1 + 0.15 * (1 - std::exp(-1.3))));
}

TEST(InsertionRenderer, SlowSlideSticksAfterItsTime) {
  ScriptedTube tube;
  tube.moveTo(10, 300);
  int ticks = 0;
  while (tube.state.phase == Phase::kSlidingIn && ticks < 1000) {
    tube.tick(10);
    ++ticks;
  }
  // 50 ms below 2 mm/s; from 33 mm/s the filter of 2 x 25 Hz needs 4.5 of its 6.4 ms time constants to get there.
  EXPECT_NEAR(ticks, 50 + 4.5 * 6.4, 5);
  EXPECT_EQ(tube.state.phase, Phase::kStuck);
}

TEST(InsertionRenderer, ReleaseFadesInThirtyMillisecondsAndKeepsTheDepth) {
  ScriptedTube tube;
  tube.moveTo(20, 500);
  const double depth_mm = tube.state.depth_mm;
  const double force_n = tube.state.force_n;
  tube.held = false;
  tube.moveTo(5, 15);
  EXPECT_NEAR(tube.state.force_n, force_n / 2, 1e-9);
  tube.moveTo(-40, 15);
  EXPECT_NEAR(tube.state.force_n, 0, kRounding);
  tube.tick(-40);
  EXPECT_EQ(tube.state.force_n, 0);
  EXPECT_EQ(tube.state.depth_mm, depth_mm);
}

TEST(InsertionRenderer, StrokesAddUpToTheDepth) {
  ScriptedTube tube;
  double sum_mm = 0;
  for (std::uint32_t number = 1; number <= 10; ++number) {
    tube.held = true;
    tube.tick(0);
    tube.moveTo(60, 400);
    tube.held = false;
    tube.tick(60);
    EXPECT_EQ(tube.state.stroke.number, number);
    EXPECT_NEAR(tube.state.stroke.end_s - tube.state.stroke.start_s, 0.401, kRounding * 1e3);
    sum_mm += tube.state.stroke.end_depth_mm - tube.state.stroke.start_depth_mm;
    tube.moveTo(0, 200);
  }
  EXPECT_NEAR(tube.state.depth_mm, sum_mm, 1e-9);
  // Each stroke loses the stretch of its spring: 0.4 N at 0.25 N/mm.
  EXPECT_NEAR(tube.state.depth_mm, 10 * (60 - 1.6), 1e-6);
}

TEST(InsertionRenderer, PressInFullMotionWaits) {
  ScriptedTube tube;
  tube.held = false;
  tube.moveTo(100, 200);  // 500 mm/s
  tube.held = true;
  tube.tick(100.5);
  EXPECT_EQ(tube.state.phase, Phase::kReleased);
  tube.moveTo(100.5, 50);
  EXPECT_EQ(tube.state.phase, Phase::kStuck);
}

TEST(InsertionRenderer, DampingResistsMotionWhileStuckUnlikeThePrintedSign) {
  ScriptedTube tube;
  tube.settings.friction.damping_n_s_mm = 0.0005;
  tube.moveTo(0, 200);  // damping has faded in
  tube.moveTo(1, 100);  // 10 mm/s, filtered for 100 ms
  const double with_n = tube.state.force_n;
  EXPECT_NEAR(with_n, 0.25 + 0.0005 * 10, 1e-5);  // exp(-200/20) of the damping is still missing
  EXPECT_NEAR(printedStaticFriction(0.25, 1, 0.0005, 10), 0.25 - 0.0005 * 10, kRounding);
}

TEST(InsertionRenderer, FollowsTheModelNoFasterThanItsSlew) {
  ScriptedTube tube;
  tube.moveTo(20, 500);
  tube.model = {0.9, true};
  ++tube.conditions;
  tube.tick(21);
  EXPECT_NEAR(tube.state.dynamic_n, 0.4 + 50 * 0.001, kRounding);
}

TEST(InsertionRenderer, StifferSpringKeepsItsForce) {
  ScriptedTube tube;
  tube.moveTo(1, 100);
  tube.settings.friction.stiffness_n_mm = 0.4;
  tube.tick(1);
  EXPECT_NEAR(tube.state.force_n, 0.25, kRounding);
  tube.settings.friction.stiffness_n_mm = 0.2;  // a softer one keeps its stretch: no energy out of nothing
  tube.tick(1);
  EXPECT_NEAR(tube.state.force_n, 0.125, kRounding);
}

}  // namespace
}  // namespace tactus::render
