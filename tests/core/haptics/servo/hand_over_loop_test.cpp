// Edits in a closed loop: what a hand feels while another person changes the model under it.
#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/haptics/sources/servo_scene.h"
#include "core/render/insertion.h"

#include "tests/core/haptics/scenes.h"
#include "tests/support/loop_measures.h"
#include "tests/support/simulated_loop.h"

namespace tactus::haptics {
namespace {

using support::largestStepN;
using support::lowestEnergyMj;
using support::rippleN;
using support::simulateLoop;

// As in tests/core/render/closed_loop_test.cpp, without edits.
constexpr double kLargestStepN = 0.03;
constexpr double kEnergyLimitMj = -0.01;
constexpr double kDepthMm = 100;

struct Edit {
  int tick = 0;
  ScenePointer scene;
};

struct Motion {
  std::string name;
  HandPlan plan;
  double duration_s = 0;
  double most_ripple_n = 0;
};

std::vector<Motion> motions() {
  return {{"slow push", push(5), 3, 0.01},
          {"stroke", stroke(60, 0.8), 1.3, 0.02},
          {"tremor while pushing", both(push(15), swing(0.3, 10)), 3, 0.02}};
}

/// The forces of a loop in which the edits, in the order of their ticks, come one after another.
std::vector<support::LoopTick> edited(const SimulatedHand& hand, const Motion& motion, const std::vector<Edit>& edits) {
  render::Insertion source(1);
  source.place(kDepthMm);
  int ticks = 0;
  std::size_t next = 0;
  const ServoScene* scene = nullptr;
  return simulateLoop(hand, {}, motion.plan, motion.duration_s, [&](double, double position_mm, double dt_s) {
    while (next < edits.size() && edits[next].tick <= ticks) scene = edits[next++].scene.get();
    ++ticks;
    render::InsertionTick tick;
    tick.active = tick.enabled = true;
    tick.position_mm = position_mm;
    tick.scene = scene;
    if (scene != nullptr) tick.fade_s = scene->fadeS();
    tick.dt_s = dt_s;
    return source.tick(tick);
  });
}

void expectCalm(const std::function<std::vector<Edit>(base::Random&)>& edits) {
  for (const SimulatedHand& hand : {kPinch, kArm, kFiveParameters}) {
    for (const Motion& motion : motions()) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(std::string(hand.name) + ", " + motion.name + ", seed " + std::to_string(seed));
        base::Random random(seed);
        const auto ticks = edited(hand, motion, edits(random));
        EXPECT_LE(largestStepN(ticks), kLargestStepN);
        EXPECT_GE(lowestEnergyMj(ticks), kEnergyLimitMj);
        EXPECT_LE(rippleN(ticks), motion.most_ripple_n);
      }
    }
  }
}

TEST(HandOverLoop, ADraggedVertexIsNoKickAndNoEnergy) {
  expectCalm([](base::Random& random) {
    std::vector<Edit> edits;
    for (int tick = 0; tick < 3000; tick += 17)
      edits.push_back({tick, ngtScene(random.uniform(), random.uniform(0, 90))});
    return edits;
  });
}

TEST(HandOverLoop, LargeEditsAreNoKickAndNoEnergy) {
  expectCalm([](base::Random&) -> std::vector<Edit> {
    return {{0, constantScene(0.2)}, {500, constantScene(1.5)}, {800, constantScene(0.15)}, {1000, constantScene(0.5)}};
  });
}

TEST(HandOverLoop, OtherParametersAreNoKickAndNoEnergy) {
  expectCalm([](base::Random& random) {
    std::vector<Edit> edits;
    for (int tick = 0; tick < 3000; tick += 170) {
      fuzzy::RendererParameters renderer;
      renderer.stiffness_n_mm = random.uniform(0.1, 0.4);
      renderer.damping_n_s_mm = random.uniform(0, 0.001);
      renderer.breakaway_ratio = random.uniform(0.05, 0.3);
      edits.push_back({tick, constantScene(0.4, renderer)});
    }
    return edits;
  });
}

}  // namespace
}  // namespace tactus::haptics
