// After a model is loaded, nothing allocates, locks, waits or calls the system: forces, batches, scenes and tubes.
#include <gtest/gtest.h>
#include <vector>

#include "core/base/random.h"

#include "tests/core/runtime/runtime_models.h"
#include "tests/support/random_model.h"
#include "tests/support/real_time_trap.h"

namespace tactus {
namespace {

TEST(RuntimeRealTime, ForcesBatchesAndScenes) {
  base::Random random(7);
  for (int m = 0; m < 60; ++m) {
    // From the first call on: nothing is prepared at the first force.
    const auto model = support::randomModel(random, {.gaussians = m % 2 == 0});
    const auto handle = support::handleOf(model);
    const size_t fixed[] = {0};
    const double value[] = {model.inputs[0].min};
    tactus_scene* made = nullptr;
    ASSERT_EQ(tactus_scene_make(handle.get(), fixed, value, 1, &made, nullptr, 0), TACTUS_OK);
    const support::SceneHandle scene(made);
    constexpr std::size_t kPoints = 1100;
    std::vector<double> points;
    for (std::size_t p = 0; p < kPoints; ++p) {
      const auto point = support::randomPoint(random, model);
      points.insert(points.end(), point.begin(), point.end());
    }
    std::vector<double> forces(kPoints);
    std::vector<unsigned char> told(kPoints);
    int fired = 0;
    support::RealTimeTrap trap;
    for (std::size_t p = 0; p < kPoints; ++p) {
      const double* const point = points.data() + p * model.inputs.size();
      forces[p] = tactus_force(handle.get(), point, &fired);
      forces[p] += tactus_expert_force(handle.get(), p % model.experts.size(), point, &fired);
      forces[p] += tactus_scene_force(made, point, &fired);
      fired += tactus_clamped(handle.get(), point);
      forces[p] += tactus_model_membership(handle.get(), p % model.experts.size(), 0, p % 3, point[0]);
    }
    tactus_force_batch(handle.get(), points.data(), kPoints, forces.data(), told.data());
    tactus_scene_force_batch(made, points.data(), kPoints, forces.data(), told.data());
    trap.disarm();
    ASSERT_EQ(trap.hits(), 0) << trap.first();
  }
}

TEST(RuntimeRealTime, TheTubeFromItsFirstStepOnAndThroughHandOvers) {
  const auto handle = support::handleOf(support::s4Shifted());
  const auto first = support::ngtSceneHandle(handle.get(), 1, 10);
  const auto second = support::ngtSceneHandle(handle.get(), 0.2, 80);
  const auto tube = support::tubeOf(first.get());
  tactus_feel feel = {};
  feel.size = sizeof feel;
  std::vector<unsigned char> state(tactus_tube_save(tube.get(), nullptr, 0));
  tactus_limits limits = {sizeof(tactus_limits), 0.1, 1};
  support::RealTimeTrap trap;
  for (int i = 0; i < 5000; ++i) {
    if (i % 400 == 399) tactus_tube_limits(tube.get(), &limits);
    if (i % 250 == 100) tactus_tube_save(tube.get(), state.data(), state.size());
    if (i % 250 == 101) tactus_tube_load(tube.get(), state.data(), state.size());
    if (i % 500 == 0) tactus_tube_scene(tube.get(), i % 1000 == 0 ? second.get() : first.get(), 0.05);
    if (i == 3000) tactus_tube_place(tube.get(), 100);
    tactus_tube_step(tube.get(), 0.05 * i, i % 1500 > 20 ? 1 : 0, 0.001, &feel);
  }
  trap.disarm();
  EXPECT_EQ(trap.hits(), 0) << trap.first();
  EXPECT_GT(feel.depth_mm, 100);
}

}  // namespace
}  // namespace tactus
