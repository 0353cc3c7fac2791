// Parameters and input at the edge of sense, the parts that must be exact, and that a step allocates nothing.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/render/insertion_renderer.h"

#include "tests/core/render/scripted_tube.h"
#include "tests/support/real_time_trap.h"

namespace tactus::render {
namespace {

TEST(RendererDegenerate, EveryParameterMayVanish) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const auto& field : fuzzy::kRendererFields) {
    for (const double value : {0.0, tiny, 1e-300}) {
      ScriptedTube tube;
      tube.settings.friction.*field.member = value;
      tube.state.depth_mm = 50;
      for (const double x : {20.0, -20.0, -200.0, 100.0}) {
        tube.moveTo(x, 200);
        ASSERT_TRUE(std::isfinite(tube.state.force_n) && std::isfinite(tube.state.depth_mm)) << field.key;
        ASSERT_LE(std::abs(tube.state.force_n), 0.46 + 1e-12) << field.key;
      }
    }
  }
}

TEST(RendererDegenerate, NoStiffnessNoForceNoRatioNoPeakNoRelaxationNoDelay) {
  ScriptedTube limp;
  limp.settings.friction.stiffness_n_mm = 0;
  limp.moveTo(100, 200);
  EXPECT_EQ(limp.state.force_n, 0);
  EXPECT_EQ(limp.state.depth_mm, 0);

  ScriptedTube even;
  even.settings.friction.breakaway_ratio = 0;
  even.moveTo(1.6, 160);
  double peak_n = 0;
  for (double x = 1.6; x < 4; x += 0.01) {
    even.tick(x);
    peak_n = std::max(peak_n, even.state.force_n);
  }
  EXPECT_NEAR(peak_n, 0.4, 1e-12);

  ScriptedTube sudden;
  sudden.settings.friction.relaxation_s = 0;
  sudden.moveTo(1.83, 183);
  sudden.tick(1.85);
  EXPECT_EQ(sudden.state.phase, Phase::kSlidingIn);
  EXPECT_NEAR(sudden.state.force_n, 0.4, 1e-12);
}

TEST(RendererDegenerate, NoFrictionSlidesFreely) {
  ScriptedTube tube;
  tube.model.force_n = -0.3;  // counts as 0
  tube.moveTo(30, 200);
  EXPECT_EQ(tube.state.force_n, 0);
  EXPECT_NEAR(tube.state.depth_mm, 30, 1e-10);
}

TEST(RendererDegenerate, InputOfAnySizeStaysFinite) {
  const double huge = std::numeric_limits<double>::max();
  const double inf = std::numeric_limits<double>::infinity();
  RendererState state;
  for (const double dt_s : {0.001, 0.0, -1.0, inf, huge, 1e-6, 1.0}) {
    for (const double position_mm : {0.0, huge, -huge, inf, 1e6, -1e6}) {
      for (const double force_n : {0.4, huge, -huge, inf}) {
        state = step(state, {position_mm, true, 0, ModelForce{force_n, true}}, {}, dt_s);
        ASSERT_TRUE(std::isfinite(state.force_n) && std::isfinite(state.depth_mm) && std::isfinite(state.dynamic_n));
        state = step(state, {0, false, 0, {}}, {}, 0.001);
      }
    }
  }
}

TEST(RendererRealTime, StepAllocatesNothing) {
  ScriptedTube tube;
  tube.moveTo(1, 10);
  const long before = support::allocations();
  tube.moveTo(40, 200);
  tube.moveTo(-40, 200);
  tube.held = false;
  tube.moveTo(0, 100);
  EXPECT_EQ(support::allocations(), before);
}

TEST(RendererDecay, IsCloseToTheExponentialAndLeavesNothingAtZero) {
  for (const double x : {0.001, 0.1, 0.157, 1.0, 10.0}) EXPECT_NEAR(decay(x, 1), std::exp(-x), x * x * x * x / 24);
  EXPECT_EQ(decay(0.001, 0), 0);
  EXPECT_EQ(decay(1e-6, 1e300), 1);
}

TEST(RendererDecay, FilterReachesAStepAndThenRests) {
  LowPass filter;
  for (int i = 0; i < 200; ++i) filter = filtered(filter, 80, 25, 0.001);
  EXPECT_NEAR(filter.value, 80, 1e-9);
  for (int i = 0; i < 1000; ++i) filter = filtered(filter, 0, 25, 0.001);
  EXPECT_EQ(filter, LowPass{});  // exactly 0: no denormal numbers
}

}  // namespace
}  // namespace tactus::render
