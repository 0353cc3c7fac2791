#include "core/render/insertion.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/core/haptics/scenes.h"

namespace tactus::render {
namespace {

using haptics::constantModel;
using haptics::constantScene;
using haptics::ngtScene;
using haptics::sceneOf;
using haptics::ScenePointer;

constexpr double kStiff = 1e3;       // no device limits the spring
constexpr double kCalmStepN = 0.03;  // largest step of a force in a tick (facts of the closed loop: docs/renderer.md)
constexpr double kRounding = 1e-12;  // of a few hundred additions of numbers near 1
constexpr int kFadeTicks = 50;

fuzzy::RendererParameters undamped(double stiffness_n_mm = 0.25) {
  fuzzy::RendererParameters renderer;
  renderer.damping_n_s_mm = 0;
  renderer.stiffness_n_mm = stiffness_n_mm;
  return renderer;
}

/// A hand that a test moves, at ticks of 1 ms.
struct Tube {
  Insertion source{kStiff};
  InsertionTick tick;
  double force_n = 0;
  double largest_step_n = 0;

  explicit Tube(ScenePointer first) {
    take(std::move(first));
    tick.active = tick.enabled = true;
  }

  void take(ScenePointer next) {
    scenes_.push_back(std::move(next));  // as the mailbox does, the old one stays until the servo has seen the new one
    tick.scene = scenes_.back().get();
    tick.fade_s = scenes_.back()->fadeS();
    if (scenes_.size() > 2) scenes_.erase(scenes_.begin());
  }

  void step() {
    const double before_n = force_n;
    force_n = source.tick(tick);
    largest_step_n = std::max(largest_step_n, std::abs(force_n - before_n));
  }

  void moveBy(double way_mm, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      tick.position_mm += way_mm / ticks;
      step();
    }
  }
  void rest(int ticks) { moveBy(0, ticks); }
  std::uint64_t asked() const { return source.counters().asked; }
  double dynamicN() const { return source.state().dynamic_n; }

 private:
  std::vector<ScenePointer> scenes_;
};

TEST(Insertion, TheNextTickAsksTheNewModelAndNoTickAfterIt) {
  Tube tube(constantScene(0.4, undamped()));
  tube.rest(1);
  tube.moveBy(1, 100);
  EXPECT_EQ(tube.asked(), 1U);
  tube.take(constantScene(0.6, undamped()));
  tube.rest(1);
  EXPECT_EQ(tube.asked(), 2U);
  // Two hundred ticks on a stuck tube, fifty of them within the fade: nothing more to ask.
  tube.rest(200);
  EXPECT_EQ(tube.asked(), 2U);
  EXPECT_EQ(tube.source.counters(), (SceneCounters{302, 2, 0, 300}));
}

TEST(Insertion, TheDifferenceFadesEvenly) {
  Tube tube(constantScene(0.4, undamped()));
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
  Tube tube(ngtScene(1, 10));
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
  Tube tube(constantScene(0.4, undamped()));
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
  Tube tube(ngtScene(1, 10));
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
    Tube tube(constantScene(0.4));
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
  Tube tube(constantScene(0.4, undamped()));
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
  Tube tube(constantScene(1.5, undamped(0.4)));
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
  Tube tube(constantScene(0.8));
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
    Tube tube(constantScene(0.5));
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

TEST(Insertion, AReleaseEndsForceAndFade) {
  Tube tube(constantScene(1.2));
  tube.rest(1);
  tube.moveBy(20, 500);
  EXPECT_GT(tube.force_n, 1);
  tube.take(constantScene(0.3, undamped(0.05), 1));
  tube.moveBy(0.4, 10);
  tube.tick.enabled = false;
  const auto asked = tube.asked();
  tube.largest_step_n = 0;
  tube.rest(30);
  EXPECT_NEAR(tube.force_n, 0, kRounding);
  EXPECT_LE(tube.largest_step_n, 1.3 / 30);
  // Released, more edits and a moving hand ask nothing, and the next press has all of the last edit.
  for (int edit = 0; edit < 10; ++edit) {
    tube.take(constantScene(0.5 + 0.01 * edit, undamped(0.1)));
    tube.moveBy(3, 100);
    EXPECT_EQ(tube.force_n, 0);
  }
  EXPECT_EQ(tube.asked(), asked);
  EXPECT_EQ(tube.source.counters().released, 30U + 1000U);
  tube.tick.enabled = true;
  tube.rest(1);
  EXPECT_EQ(tube.force_n, 0);
  EXPECT_NEAR(tube.dynamicN(), 0.59, 1e-15);
  EXPECT_EQ(tube.source.rendered().stiffness_n_mm, 0.1);
  EXPECT_EQ(tube.asked(), asked + 1);
}

TEST(Insertion, AHoleKeepsTheForceUntilTheNewModelFires) {
  Tube tube(constantScene(0.4, undamped()));
  tube.rest(1);
  tube.moveBy(10, 500);
  const double depth_mm = tube.source.state().depth_mm;
  tube.take(sceneOf(constantModel(0.8, undamped(), depth_mm + 5), {}));
  tube.moveBy(3, 150);
  EXPECT_TRUE(tube.source.state().held);
  EXPECT_NEAR(tube.dynamicN(), 0.4, 1e-15);
  // Half a fade after the edge of the hole the force is half way.
  while (tube.source.state().held) tube.moveBy(0.02, 1);
  EXPECT_NEAR(tube.dynamicN(), 0.4, 1e-15);
  tube.moveBy(0.5, 25);
  EXPECT_NEAR(tube.dynamicN(), 0.6, kRounding);
  tube.moveBy(0.5, 25);
  EXPECT_NEAR(tube.dynamicN(), 0.8, 1e-15);
}

TEST(Insertion, TheDeviceBoundsTheStiffness) {
  Tube tube(constantScene(0.8, undamped(0.5)));
  tube.source = Insertion(0.3);
  tube.rest(1);
  tube.moveBy(1, 100);
  EXPECT_NEAR(tube.force_n, 0.3, kRounding);
  EXPECT_TRUE(tube.source.stiffnessLimited());
  tube.take(constantScene(0.8, undamped(0.2)));
  tube.rest(1 + kFadeTicks);
  EXPECT_FALSE(tube.source.stiffnessLimited());
  EXPECT_EQ(tube.source.rendered().stiffness_n_mm, 0.2);
}

TEST(Insertion, AnotherPlacementBeginsWithoutForceAtItsDepth) {
  Tube tube(constantScene(1.2, undamped()));
  tube.rest(1);
  tube.moveBy(30, 600);
  tube.tick.enabled = false;
  tube.rest(1);
  tube.tick.enabled = true;
  tube.moveBy(30, 600);
  EXPECT_EQ(tube.source.state().stroke.number, 2U);
  const double before_n = tube.force_n;
  tube.largest_step_n = 0;
  tube.source.place(120);
  tube.rest(1);
  EXPECT_EQ(tube.source.state().depth_mm, 120);
  EXPECT_EQ(tube.source.state().stretch_mm, 0);
  EXPECT_EQ(tube.source.state().stroke.number, 1U);
  tube.rest(29);
  EXPECT_NEAR(tube.force_n, 0, kRounding);
  EXPECT_LE(tube.largest_step_n, before_n / 30 + kRounding);
}

TEST(Insertion, ADepthOffsetIsFeltWithoutAStep) {
  Tube tube(ngtScene(0.1, 80));
  tube.rest(1);
  tube.moveBy(40, 1500);
  tube.largest_step_n = 0;
  auto model = support::s4Shifted();
  model.renderer.emplace();
  model.renderer->depth_offset_mm = 100;
  const auto shifted = sceneOf(model, {{"lubrication", 0.1}, {"neck_flexion", 80}});
  tube.take(shifted);
  tube.rest(100);
  const auto asked = tube.source.state().asked;
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->depth_mm, tube.source.state().depth_mm + 100);
  EXPECT_EQ(tube.source.state().model_n, shifted->force(*asked).force_n);
  EXPECT_LE(tube.largest_step_n, kCalmStepN);
}

TEST(Insertion, AnotherSceneAtTheSameAddressIsAnotherScene) {
  const ScenePointer first = constantScene(0.4, undamped());
  const ScenePointer second = constantScene(0.9, undamped());
  EXPECT_NE(first->serial(), 0U);
  EXPECT_NE(first->serial(), second->serial());
  TubeScene place = *first;
  Tube tube(first);
  tube.tick.scene = &place;
  tube.rest(1);
  tube.moveBy(1, 100);
  EXPECT_EQ(tube.asked(), 1U);
  // As when several sets of orders come and go between two ticks, and memory is used again.
  place = *second;
  for (int i = 0; i <= kFadeTicks; ++i) {
    tube.rest(1);
    EXPECT_NEAR(tube.dynamicN(), 0.4 + 0.5 * i / kFadeTicks, kRounding);
  }
  EXPECT_EQ(tube.asked(), 2U);
}

TEST(Insertion, PlacementsInARowDoNotDelayTheFade) {
  Tube tube(constantScene(1.2, undamped()));
  tube.rest(1);
  tube.moveBy(30, 600);
  const double before_n = tube.force_n;
  tube.tick.enabled = false;
  tube.largest_step_n = 0;
  for (int i = 0; i < 30; ++i) {
    if (i % 5 == 0) tube.source.place(100 + i);
    tube.rest(1);
  }
  EXPECT_NEAR(tube.force_n, 0, kRounding);
  EXPECT_LE(tube.largest_step_n, before_n / 30 + kRounding);
}

TEST(Insertion, WithoutASceneThereIsNoForce) {
  Tube tube(constantScene(0.5));
  tube.rest(1);
  tube.moveBy(1.5, 100);
  tube.tick.scene = nullptr;
  tube.rest(31);
  EXPECT_EQ(tube.force_n, 0);
  EXPECT_EQ(tube.source.state().phase, Phase::kReleased);
  tube.take(constantScene(0.5));
  tube.rest(1);
  EXPECT_EQ(tube.source.state().phase, Phase::kStuck);
}

TEST(Insertion, APositionThatIsNoneLetsGo) {
  Tube tube(constantScene(0.5));
  tube.rest(1);
  tube.moveBy(1.5, 100);
  tube.tick.position_mm = std::numeric_limits<double>::quiet_NaN();
  tube.rest(1);
  EXPECT_EQ(tube.source.state().fault, Fault::kPosition);
  tube.rest(30);
  EXPECT_EQ(tube.force_n, 0);
}

TEST(Insertion, ACopyGoesOnTheSame) {
  Tube tube(ngtScene(0.3, 40));
  tube.rest(1);
  tube.moveBy(20, 300);
  tube.take(ngtScene(0.9, 40));
  tube.moveBy(1, 20);
  Insertion copy = tube.source;
  for (int i = 0; i < 200; ++i) {
    tube.moveBy(0.03, 1);
    ASSERT_EQ(copy.tick(tube.tick), tube.force_n);
    ASSERT_EQ(copy.state(), tube.source.state());
  }
}

}  // namespace
}  // namespace tactus::render
