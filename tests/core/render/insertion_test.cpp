#include "core/render/insertion.h"

#include <gtest/gtest.h>
#include <limits>

#include "tests/core/haptics/scenes.h"
#include "tests/core/render/pushed_tube.h"

namespace tactus::render {
namespace {

using haptics::constantModel;
using haptics::constantScene;
using haptics::ngtScene;
using haptics::sceneOf;
using haptics::ScenePointer;

TEST(Insertion, TheNextTickAsksTheNewModelAndNoTickAfterIt) {
  PushedTube tube(constantScene(0.4, undamped()));
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

TEST(Insertion, AReleaseEndsForceAndFade) {
  PushedTube tube(constantScene(1.2));
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
  PushedTube tube(constantScene(0.4, undamped()));
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
  PushedTube tube(constantScene(0.8, undamped(0.5)));
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
  PushedTube tube(constantScene(1.2, undamped()));
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
  PushedTube tube(ngtScene(0.1, 80));
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
  PushedTube tube(first);
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
  PushedTube tube(constantScene(1.2, undamped()));
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
  PushedTube tube(constantScene(0.5));
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
  PushedTube tube(constantScene(0.5));
  tube.rest(1);
  tube.moveBy(1.5, 100);
  tube.tick.position_mm = std::numeric_limits<double>::quiet_NaN();
  tube.rest(1);
  EXPECT_EQ(tube.source.state().fault, Fault::kPosition);
  tube.rest(30);
  EXPECT_EQ(tube.force_n, 0);
}

TEST(Insertion, ACopyGoesOnTheSame) {
  PushedTube tube(ngtScene(0.3, 40));
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
