// The tube is the servo's insertion before its limits, sample by sample.
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/base/random.h"
#include "core/haptics/servo/servo_core.h"

#include "tests/core/haptics/scenes.h"
#include "tests/core/runtime/runtime_models.h"

namespace tactus {
namespace {

constexpr double kTickS = 0.001;

tactus_feel step(tactus_tube* tube, double position_mm, bool held, double dt_s = kTickS,
                 tactus_status wanted = TACTUS_OK) {
  tactus_feel feel = {};
  feel.size = sizeof feel;
  EXPECT_EQ(tactus_tube_step(tube, position_mm, held ? 1 : 0, dt_s, &feel), wanted);
  return feel;
}

int phaseOf(render::Phase phase) {
  return phase == render::Phase::kReleased ? 0 : phase == render::Phase::kStuck ? 1 : 2;
}

TEST(RuntimeTube, FeelsWhatTheServoRendersBeforeItsLimits) {
  // A device that limits neither the spring nor the rate.
  haptics::DeviceInfo device;
  device.damping_n_s_mm = 1;
  haptics::ServoCore servo(device, {});
  haptics::ServoOrders orders;
  orders.source = haptics::ForceSource::kInsertion;
  orders.limits.fade_in_s = 0;
  haptics::ServoTick tick;
  tick.orders = &orders;
  tick.orders_number = 1;

  const auto model = support::s4Shifted();
  const auto handle = support::handleOf(model);
  orders.scene = haptics::ngtScene(1, 45);
  auto scene = support::ngtSceneHandle(handle.get(), 1, 45);
  const auto tube = support::tubeOf(scene.get());
  tactus_tube_place(tube.get(), 20);
  orders.placement = 1;
  orders.start_depth_mm = 20;

  base::Random random(4);
  double position_mm = 0;
  double speed_mm_s = 0;
  double largest_n = 0;
  int held_ticks = 0;
  std::vector<haptics::ScenePointer> kept;
  for (int i = 0; i < 20'000; ++i) {
    // Armed from the fifth tick on; then strokes of a second, released for a quarter.
    orders.armed = i >= 5;
    const bool button = i > 20 && i % 1250 < 1000;
    if (i % 200 == 0) speed_mm_s = random.uniform(-30, 160);
    position_mm += speed_mm_s * kTickS;
    if (i % 777 == 776) {
      // Another neck flexion, over a second or at once.
      const double neck_deg = random.uniform(0, 90);
      const double fade_s = random.below(3) == 0 ? 0 : random.uniform(0.01, 1);
      kept.push_back(orders.scene);
      orders.scene = haptics::ngtScene(0.6, neck_deg, fade_s);
      ++tick.orders_number;
      scene = support::ngtSceneHandle(handle.get(), 0.6, neck_deg);
      tactus_tube_scene(tube.get(), scene.get(), fade_s);
    }
    tick.now_ns += 1'000'000;
    ++tick.device.number;
    tick.device.time_ns = tick.device.written_ns = tick.now_ns;
    tick.device.buttons = button ? 1 : 0;
    tick.device.position_mm = orders.axis.originMm() + position_mm * orders.axis.inwards();
    const haptics::Sample sample = servo.tick(tick);
    const tactus_feel feel = step(tube.get(), sample.position_mm, sample.enabled);
    ASSERT_EQ(sample.trip, haptics::TripCause::kNone) << i;
    ASSERT_EQ(feel.force_n, sample.source_force_n) << i;
    ASSERT_EQ(feel.depth_mm, sample.depth_mm) << i;
    ASSERT_EQ(feel.speed_mm_s, sample.speed_mm_s) << i;
    ASSERT_EQ(feel.slip_speed_mm_s, sample.slip_speed_mm_s) << i;
    ASSERT_EQ(feel.stretch_mm, sample.stretch_mm) << i;
    ASSERT_EQ(feel.model_force_n, sample.model_force_n) << i;
    ASSERT_EQ(feel.phase, phaseOf(sample.phase)) << i;
    ASSERT_EQ(feel.held_last != 0, sample.held) << i;
    ASSERT_EQ(feel.stroke, sample.stroke) << i;
    largest_n = std::max(largest_n, feel.force_n);
    held_ticks += feel.held_last;
  }
  EXPECT_GT(largest_n, 0.4);
  EXPECT_GT(held_ticks, 0);
}

TEST(RuntimeTube, LivesWithoutItsScene) {
  const auto handle = support::handleOf(haptics::constantModel(0.5));
  tactus_scene* scene = nullptr;
  // The model of the test has no rate: its force depends on the way alone.
  ASSERT_EQ(tactus_scene_make(handle.get(), nullptr, nullptr, 0, &scene, nullptr, 0), TACTUS_OK);
  tactus_tube* tube = nullptr;
  EXPECT_EQ(tactus_tube_make(scene, &tube, nullptr, 0), TACTUS_OK);
  tactus_tube_free(tube);
  tactus_scene_free(scene);

  auto ngt = support::handleOf(support::s4Shifted());
  const size_t fixed[] = {0, 1, 3};
  const double values[] = {1, 10, 50};
  ASSERT_EQ(tactus_scene_make(ngt.get(), fixed, values, 3, &scene, nullptr, 0), TACTUS_OK);
  std::array<char, 200> message{};
  EXPECT_EQ(tactus_tube_make(scene, &tube, message.data(), message.size()), TACTUS_BAD_ARGUMENT);
  EXPECT_STREQ(message.data(), "inputs of the scene: found 'depth', wanted 'depth' and 'speed' and no other");
  tactus_scene_free(scene);
  auto first = support::ngtSceneHandle(ngt.get(), 1, 10);
  const auto felt = support::tubeOf(first.get());
  ngt.reset();
  first.reset();
  double position_mm = 0;
  double force_n = 0;
  for (int i = 0; i < 2000; ++i) force_n = step(felt.get(), position_mm += 0.03, true).force_n;
  EXPECT_GT(force_n, 0.05);
}

TEST(RuntimeTube, APositionOrATimeThatIsNoneLetsGo) {
  const auto ngt = support::handleOf(support::s4Shifted());
  const auto scene = support::ngtSceneHandle(ngt.get(), 1, 10);
  const double none = std::nan("");
  for (const auto& [position_mm, dt_s] : {std::pair{none, kTickS},
                                          {INFINITY, kTickS},
                                          {2e6, kTickS},
                                          {50.0, none},
                                          {50.0, 0.0},
                                          {50.0, -1.0},
                                          {50.0, INFINITY},
                                          {50.0, 1.5}}) {
    const auto tube = support::tubeOf(scene.get());
    double hand_mm = 0;
    for (int i = 0; i < 1500; ++i) step(tube.get(), hand_mm += 0.03, true);
    // A fade is in progress, so that a wrong time meets it.
    tactus_tube_scene(tube.get(), scene.get(), 1);
    step(tube.get(), hand_mm, true);
    const tactus_feel feel = step(tube.get(), position_mm, true, dt_s, TACTUS_BAD_ARGUMENT);
    EXPECT_EQ(feel.phase, 0);
    EXPECT_TRUE(std::isfinite(feel.force_n) && std::isfinite(feel.depth_mm) && std::isfinite(feel.speed_mm_s));
    for (int i = 0; i < 40; ++i) EXPECT_EQ(step(tube.get(), hand_mm, true).phase, 0);
    EXPECT_EQ(step(tube.get(), hand_mm, true).force_n, 0);
    step(tube.get(), hand_mm, false);
    EXPECT_EQ(step(tube.get(), hand_mm, true).phase, 1);
  }
}

TEST(RuntimeTube, ASmallerFeelThanTheLibrarysIsRefused) {
  const auto ngt = support::handleOf(support::s4Shifted());
  const auto scene = support::ngtSceneHandle(ngt.get(), 1, 10);
  const auto tube = support::tubeOf(scene.get());
  tactus_feel feel = {};
  feel.force_n = 5;
  EXPECT_EQ(tactus_tube_step(tube.get(), 0, 1, kTickS, &feel), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(tactus_tube_step(tube.get(), 0, 1, kTickS, nullptr), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(feel.force_n, 5);
  // A caller with a later header passes a larger one.
  feel.size = sizeof feel + 64;
  EXPECT_EQ(tactus_tube_step(tube.get(), 0, 1, kTickS, &feel), TACTUS_OK);
  EXPECT_EQ(feel.size, sizeof feel + 64);
}

TEST(RuntimeTube, ADepthThatIsNoneIsNoPlacement) {
  const auto ngt = support::handleOf(support::s4Shifted());
  const auto scene = support::ngtSceneHandle(ngt.get(), 1, 10);
  const auto tube = support::tubeOf(scene.get());
  tactus_tube_place(tube.get(), 120);
  tactus_tube_place(tube.get(), std::nan(""));
  tactus_tube_place(tube.get(), INFINITY);
  EXPECT_EQ(step(tube.get(), 0, false).depth_mm, 120);
}

TEST(RuntimeTube, AnotherSceneNeverKicks) {
  const auto ngt = support::handleOf(support::s4Shifted());
  auto scene = support::ngtSceneHandle(ngt.get(), 1, 10);
  const auto tube = support::tubeOf(scene.get());
  tactus_tube_place(tube.get(), 170);
  double hand_mm = 0;
  for (int i = 0; i < 500; ++i) step(tube.get(), hand_mm += 0.02, true);
  double before_n = step(tube.get(), hand_mm, true).force_n;
  double largest_step_n = 0;
  base::Random random(5);
  for (int i = 0; i < 3000; ++i) {
    if (i % 30 == 0) {
      scene = support::ngtSceneHandle(ngt.get(), random.uniform(0, 1), random.uniform(0, 90));
      tactus_tube_scene(tube.get(), scene.get(), std::nan(""));
    }
    const double force_n = step(tube.get(), hand_mm += 0.02, true).force_n;
    largest_step_n = std::max(largest_step_n, std::abs(force_n - before_n));
    before_n = force_n;
  }
  EXPECT_LE(largest_step_n, 0.03);  // the largest step of a calm force in a tick: tests of the insertion
}

}  // namespace
}  // namespace tactus
