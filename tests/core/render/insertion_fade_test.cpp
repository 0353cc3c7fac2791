// How another model comes into the hand: it fades in, never kicks, and takes no energy from the spring.
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"
#include "core/render/insertion.h"

#include "tests/core/haptics/scenes.h"
#include "tests/core/render/pushed_tube.h"

namespace tactus::render {
namespace {

using haptics::constantScene;
using haptics::ngtScene;

TEST(Insertion, TheDifferenceFadesEvenly) {
  PushedTube tube(constantScene(0.4, undamped()));
  tube.rest(1);
  tube.moveBy(1, 100);
  tube.take(constantScene(0.9, undamped()));
  for (int i = 0; i <= kFadeTicks; ++i) {
    tube.rest(1);
    EXPECT_NEAR(tube.dynamicN(), 0.4 + 0.5 * i / kFadeTicks, kRounding);
  }
  EXPECT_NEAR(tube.dynamicN(), 0.9, 1e-15);
}

TEST(Insertion, ANeckFlexionGestureTakesItsTime) {
  PushedTube tube(ngtScene(1, 10));
  tube.rest(1);
  tube.source.place(170);
  tube.moveBy(1, 100);
  const double small_n = ngtScene(1, 10)->force({170, 0}).force_n;
  const double large_n = ngtScene(1, 85)->force({170, 0}).force_n;
  ASSERT_GT(large_n, small_n + 0.02);
  EXPECT_NEAR(tube.dynamicN(), small_n, 1e-15);
  tube.take(ngtScene(1, 85, 1));
  tube.rest(501);
  EXPECT_NEAR(tube.dynamicN(), (small_n + large_n) / 2, kRounding);
  tube.rest(500);
  EXPECT_NEAR(tube.dynamicN(), large_n, 1e-15);
}

TEST(Insertion, AnEditWithinAGestureDoesNotHurryIt) {
  PushedTube tube(constantScene(0.4, undamped()));
  tube.rest(1);
  tube.moveBy(1, 100);
  tube.take(constantScene(0.8, undamped(), 1));
  tube.rest(500);
  tube.take(constantScene(0.7, undamped()));
  for (double last_n = tube.dynamicN(); tube.source.counters().ticks < 1102; last_n = tube.dynamicN()) {
    tube.rest(1);
    EXPECT_LE(std::abs(tube.dynamicN() - last_n), 0.4 / 1000 + kRounding);
  }
  EXPECT_NEAR(tube.dynamicN(), 0.7, 1e-15);
}

TEST(Insertion, SlidingFeelsExactlyTheNewModelAfterTheFade) {
  const auto model = support::s4Shifted();
  const auto compiled = fuzzy::compile(model);
  PushedTube tube(ngtScene(1, 10));
  tube.rest(1);
  tube.source.place(60);
  tube.moveBy(30, 1000);
  tube.largest_step_n = 0;
  tube.take(ngtScene(0.1, 80));
  tube.moveBy(1.5, 50);
  for (int i = 0; i < 500; ++i) {
    tube.moveBy(0.03, 1);
    const auto asked = tube.source.state().asked;
    ASSERT_TRUE(asked);
    const double exact_n = compiled->evaluate(std::array{0.1, 80.0, asked->depth_mm, asked->speed_mm_s}).force_n;
    // Following the model is one addition and one subtraction.
    ASSERT_NEAR(tube.dynamicN(), exact_n, 2e-16);
  }
  EXPECT_EQ(tube.source.state().phase, Phase::kSlidingIn);
  // 500 ms on the plateau of a region: the friction has relaxed to F_d.
  EXPECT_NEAR(tube.force_n, tube.dynamicN(), 1e-6);
  EXPECT_LE(tube.largest_step_n, kCalmStepN);
}

TEST(Insertion, DraggingAVertexNeverKicks) {
  for (const bool sliding : {false, true}) {
    PushedTube tube(constantScene(0.4));
    tube.rest(1);
    tube.moveBy(sliding ? 20 : 1.2, 700);
    tube.largest_step_n = 0;
    base::Random random(5);
    double last_n = 0;
    // 60 edits a second for 2 s, as wild as a model can be.
    for (int edit = 0; edit < 120; ++edit) {
      last_n = random.uniform(0.1, 1.8);
      tube.take(constantScene(last_n));
      tube.moveBy(sliding ? 0.4 : 0, edit % 3 == 0 ? 16 : 17);
    }
    tube.moveBy(sliding ? 1.3 : 0, 51);
    EXPECT_NEAR(tube.dynamicN(), last_n, 1e-15);
    EXPECT_LE(tube.largest_step_n, kCalmStepN) << sliding;
  }
}

TEST(Insertion, AnotherModelAtEveryTickIsFollowedAllTheSame) {
  PushedTube tube(constantScene(0.4, undamped()));
  tube.rest(1);
  tube.moveBy(1, 100);
  for (int i = 1; i <= 500; ++i) {
    tube.take(constantScene(0.4 + 0.001 * i, undamped()));
    tube.rest(1);
  }
  // A target that rises by 0.001 N a tick, followed by a fiftieth of the difference: 50 ticks behind, plus this one.
  EXPECT_NEAR(tube.dynamicN(), 0.9 - 0.05, 0.002);
}

TEST(Insertion, ASofterSpringFadesAndAStifferOneKeepsItsForce) {
  PushedTube tube(constantScene(1.5, undamped(0.4)));
  tube.rest(1);
  tube.moveBy(2, 400);
  EXPECT_NEAR(tube.force_n, 0.8, kRounding);
  tube.largest_step_n = 0;
  tube.take(constantScene(1.5, undamped(0.1)));
  tube.rest(26);
  EXPECT_NEAR(tube.force_n, 0.5, kRounding);
  tube.rest(25);
  EXPECT_NEAR(tube.force_n, 0.2, kRounding);
  EXPECT_EQ(tube.source.rendered().stiffness_n_mm, 0.1);
  EXPECT_LE(tube.largest_step_n, 0.6 / kFadeTicks + kRounding);
  tube.take(constantScene(1.5, undamped(0.4)));
  tube.rest(60);
  EXPECT_NEAR(tube.force_n, 0.2, kRounding);
  EXPECT_EQ(tube.source.rendered().stiffness_n_mm, 0.4);
}

TEST(Insertion, WildParametersNeverKick) {
  base::Random random(11);
  PushedTube tube(constantScene(0.8));
  tube.rest(1);
  tube.moveBy(15, 500);
  tube.largest_step_n = 0;
  for (int edit = 0; edit < 200; ++edit) {
    fuzzy::RendererParameters renderer;
    renderer.stiffness_n_mm = random.uniform(0.05, 0.6);
    renderer.damping_n_s_mm = random.uniform(0, 0.004);
    renderer.breakaway_ratio = random.uniform(0, 1);
    renderer.withdrawal_ratio = random.uniform(0, 2);
    renderer.restick_mm = random.uniform(0, 1);
    renderer.depth_offset_mm = random.uniform(-100, 100);
    tube.take(constantScene(0.8, renderer));
    tube.moveBy(random.uniform(-0.3, 0.5), 17);
  }
  // The motion itself makes up to 0.6 N/mm * 0.5 mm / 17 = 0.018 N a tick.
  EXPECT_LE(tube.largest_step_n, 0.018 + kCalmStepN);
}

TEST(Insertion, HandOversTakeNoEnergyFromTheSpring) {
  base::Random random(3);
  for (int run = 0; run < 20; ++run) {
    PushedTube tube(constantScene(0.5));
    double taken = 0;
    double velocity_mm_s = 0;
    for (int i = 0; i < 1500; ++i) {
      if (random.below(20) == 0) {
        const double fade_s = random.below(4) == 0 ? 0 : random.uniform(0.001, 0.2);
        tube.take(constantScene(random.uniform(0.1, 1.8), undamped(random.uniform(0.02, 3)), fade_s));
      }
      const auto before = tube.source.state();
      velocity_mm_s += random.uniform(-8, 8) - 0.02 * velocity_mm_s;
      tube.moveBy(velocity_mm_s * 0.001, 1);
      const auto& after = tube.source.state();
      if (before.phase == Phase::kReleased) continue;
      // The force held during the tick is that of the old spring; of what the hold can hide, the larger counts.
      const double dx = tube.tick.position_mm - *before.position_mm;
      taken += before.stiffness_n_mm * before.stretch_mm * dx +
               std::max(before.stiffness_n_mm, after.stiffness_n_mm) * dx * dx / 2;
      ASSERT_GE(taken - after.stiffness_n_mm * after.stretch_mm * after.stretch_mm / 2, -1e-12 * (1 + taken));
    }
  }
}

}  // namespace
}  // namespace tactus::render
