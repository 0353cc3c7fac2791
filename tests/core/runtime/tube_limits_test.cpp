// Limits of the tube, the region of its tip, and callers that know less of tactus_feel.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <gtest/gtest.h>

#include "tests/core/runtime/runtime_models.h"

namespace tactus {
namespace {

tactus_feel pushed(tactus_tube* tube, double position_mm, bool held = true) {
  tactus_feel feel = {};
  feel.size = sizeof feel;
  EXPECT_EQ(tactus_tube_step(tube, position_mm, held ? 1 : 0, 0.001, &feel), TACTUS_OK);
  return feel;
}

/// A scene whose force is `force_n` everywhere: the centroid of a symmetric triangle is its middle.
support::SceneHandle evenScene(double force_n, const fuzzy::RendererParameters& renderer = {}) {
  auto model = support::ngtVariables();
  model.output.max = 2 * force_n;
  model.output.terms = {{"even", "", fuzzy::Shape::kTriangle, {0, force_n, 2 * force_n}}};
  model.inputs[2].terms = {{"all", "", fuzzy::Shape::kTrapezoid, {0, 0, 600, 600}}};
  fuzzy::Expert expert;
  expert.id = "E";
  expert.rules.push_back({{{"depth", "all"}}, "even"});
  model.experts.push_back(expert);
  model.renderer = renderer;
  return support::ngtSceneHandle(support::handleOf(model).get(), 1, 45);
}

tactus_status limit(tactus_tube* tube, double stiffness_n_mm, double cap_n) {
  const tactus_limits limits{sizeof(tactus_limits), stiffness_n_mm, cap_n};
  return tactus_tube_limits(tube, &limits);
}

TEST(RuntimeLimits, TheSpringIsTheSofterOne) {
  const auto scene = evenScene(1);
  for (const auto& [limit_n_mm, rendered_n_mm] : {std::pair{0.1, 0.1}, {3.0, 0.25}, {0.0, 0.25}}) {
    const auto tube = support::tubeOf(scene.get());
    ASSERT_EQ(limit(tube.get(), limit_n_mm, 0), TACTUS_OK);
    pushed(tube.get(), 0);
    // Stuck, so the force is the spring's, and damping vanishes with the speed.
    double hand_mm = 0;
    for (int i = 0; i < 200; ++i) pushed(tube.get(), hand_mm += 0.01);
    tactus_feel feel = {};
    for (int i = 0; i < 2000; ++i) feel = pushed(tube.get(), hand_mm);
    EXPECT_EQ(feel.phase, 1);
    EXPECT_NEAR(feel.force_n, rendered_n_mm * 2, 1e-9);
    EXPECT_EQ(feel.limited, rendered_n_mm < 0.25 ? 1 : 0);
    EXPECT_EQ(pushed(tube.get(), hand_mm, false).limited, 0);
  }
}

TEST(RuntimeLimits, TheTubeSlipsAtTheCap) {
  // A model of 3 N: the usual cap of 2 N holds it, whatever the caller allows.
  const auto scene = evenScene(3);
  for (const auto& [cap_n, wanted_n] : {std::pair{0.0, 2.0}, {5.0, 2.0}, {0.5, 0.5}}) {
    const auto tube = support::tubeOf(scene.get());
    ASSERT_EQ(limit(tube.get(), 0, cap_n), TACTUS_OK);
    double hand_mm = 0;
    double largest_n = 0;
    EXPECT_EQ(pushed(tube.get(), hand_mm).limited, 0);
    tactus_feel feel = {};
    for (int i = 0; i < 3000; ++i) {
      feel = pushed(tube.get(), hand_mm += 0.03);
      largest_n = std::max(largest_n, feel.force_n);
      EXPECT_TRUE(feel.limited == 0 || feel.force_n >= 0.9 * wanted_n) << i;
    }
    EXPECT_EQ(feel.phase, 2);
    EXPECT_GT(feel.depth_mm, 70);
    EXPECT_NEAR(largest_n, wanted_n, 1e-12);
    EXPECT_EQ(feel.limited, 1);
  }
}

TEST(RuntimeLimits, AreTakenInTheHandWithoutAKick) {
  const auto scene = evenScene(1);
  const auto tube = support::tubeOf(scene.get());
  pushed(tube.get(), 0);
  double before_n = 0;
  for (int i = 0; i < 2000; ++i) before_n = pushed(tube.get(), std::min(3.0, 0.01 * i)).force_n;
  ASSERT_NEAR(before_n, 0.75, 1e-6);
  double largest_step_n = 0;
  for (const double softer : {0.1, 0.25, 0.05, 0.0}) {
    ASSERT_EQ(limit(tube.get(), softer, 0), TACTUS_OK);
    for (int i = 0; i < 200; ++i) {
      const double force_n = pushed(tube.get(), 3).force_n;
      largest_step_n = std::max(largest_step_n, std::abs(force_n - before_n));
      before_n = force_n;
    }
  }
  // At most 0.6 N within 50 ticks.
  EXPECT_LE(largest_step_n, 0.6 / 50 + 1e-9);
  EXPECT_LE(before_n, 0.15 + 1e-9);  // a stiffer spring keeps its force: nothing is given to the hand
}

TEST(RuntimeLimits, NonsenseChangesNothing) {
  const auto scene = evenScene(1);
  const auto tube = support::tubeOf(scene.get());
  ASSERT_EQ(limit(tube.get(), 0, 0.3), TACTUS_OK);
  for (const double wrong : {-1.0, -1e-300, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    EXPECT_EQ(limit(tube.get(), wrong, 0), TACTUS_BAD_ARGUMENT);
    EXPECT_EQ(limit(tube.get(), 0, wrong), TACTUS_BAD_ARGUMENT);
  }
  tactus_limits small{sizeof(tactus_limits) - 1, 0, 0};
  EXPECT_EQ(tactus_tube_limits(tube.get(), &small), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(tactus_tube_limits(nullptr, &small), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(tactus_tube_limits(tube.get(), nullptr), TACTUS_BAD_ARGUMENT);
  double largest_n = 0;
  for (int i = 0; i < 1000; ++i) largest_n = std::max(largest_n, pushed(tube.get(), 0.03 * i).force_n);
  EXPECT_NEAR(largest_n, 0.3, 1e-12);
}

TEST(RuntimeRegion, IsTheStrongestTermOfTheDepth) {
  auto model = support::s4Shifted();
  model.renderer.emplace();
  model.renderer->depth_offset_mm = 7;
  const auto handle = support::handleOf(model);
  const auto scene = support::ngtSceneHandle(handle.get(), 1, 45);
  const auto tube = support::tubeOf(scene.get());
  const std::size_t terms = tactus_model_input_terms(handle.get(), 2);
  for (double depth_mm = 0; depth_mm <= 593; depth_mm += 3.7) {
    tactus_tube_place(tube.get(), depth_mm);
    const int region = pushed(tube.get(), 0, false).region;
    ASSERT_GE(region, 0);
    const auto at = [&](std::size_t t) { return tactus_model_membership(handle.get(), 0, 2, t, depth_mm + 7); };
    for (std::size_t t = 0; t < terms; ++t) {
      const double strongest = at(static_cast<std::size_t>(region));
      EXPECT_TRUE(t < static_cast<std::size_t>(region) ? at(t) < strongest : at(t) <= strongest) << depth_mm;
    }
  }
  // A gap between the words is no region.
  model.inputs[2].terms[0].points = {10, 20, 30, 40};
  model.renderer.reset();
  const auto gap = support::ngtSceneHandle(support::handleOf(model).get(), 1, 45);
  EXPECT_EQ(pushed(support::tubeOf(gap.get()).get(), 0, false).region, -1);
}

TEST(RuntimePlace, EndsWithTheModel) {
  fuzzy::RendererParameters renderer;
  renderer.depth_offset_mm = 20;
  const auto scene = evenScene(0.5, renderer);
  const auto tube = support::tubeOf(scene.get());
  tactus_tube_place(tube.get(), 1e5);
  EXPECT_EQ(pushed(tube.get(), 0, false).depth_mm, 580);
  tactus_tube_place(tube.get(), 120);
  EXPECT_EQ(pushed(tube.get(), 0, false).depth_mm, 120);
}

/// tactus_feel of interface 1.
struct FirstFeel {
  std::size_t size;
  double force_n, depth_mm, speed_mm_s, slip_speed_mm_s, stretch_mm, model_force_n;
  int phase, held_last;
  unsigned stroke;
};

TEST(RuntimeFeel, ACallerOfInterface1GetsItsMembersAlone) {
  const auto scene = evenScene(1);
  const auto tube = support::tubeOf(scene.get());
  unsigned char bytes[sizeof(tactus_feel)];
  std::memset(bytes, 0xA5, sizeof bytes);
  const std::size_t first = sizeof(FirstFeel);
  std::memcpy(bytes, &first, sizeof first);
  pushed(tube.get(), 0);
  ASSERT_EQ(tactus_tube_step(tube.get(), 1, 1, 0.001, reinterpret_cast<tactus_feel*>(bytes)), TACTUS_OK);
  FirstFeel feel;
  std::memcpy(&feel, bytes, sizeof feel);
  EXPECT_GT(feel.force_n, 0.2);
  EXPECT_EQ(feel.stroke, 1U);
  for (std::size_t i = offsetof(FirstFeel, stroke) + sizeof feel.stroke; i < sizeof bytes; ++i)
    EXPECT_EQ(bytes[i], 0xA5) << i;
  const std::size_t less = sizeof(FirstFeel) - 1;
  std::memcpy(bytes, &less, sizeof less);
  EXPECT_EQ(tactus_tube_step(tube.get(), 1, 1, 0.001, reinterpret_cast<tactus_feel*>(bytes)), TACTUS_BAD_ARGUMENT);
}

}  // namespace
}  // namespace tactus
