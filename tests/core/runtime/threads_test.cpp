// Eight threads share one model and one scene, while others make and free some of their own.
#include <atomic>
#include <gtest/gtest.h>
#include <thread>
#include <vector>

#include "core/base/random.h"

#include "tests/core/runtime/runtime_models.h"
#include "tests/support/random_model.h"

namespace tactus {
namespace {

TEST(RuntimeThreads, EightReadersSeeTheSameForces) {
  const auto model = support::s4Shifted();
  const auto handle = support::handleOf(model);
  const auto scene = support::ngtSceneHandle(handle.get(), 0.7, 45);
  const auto shared_handle = handle.get();
  constexpr std::size_t kPoints = 500;
  base::Random random(6);
  std::vector<double> points;
  std::vector<double> wanted_n;
  std::vector<double> wanted_scene_n;
  for (std::size_t p = 0; p < kPoints; ++p) {
    const auto point = support::randomPoint(random, model);
    points.insert(points.end(), point.begin(), point.end());
    wanted_n.push_back(tactus_force(shared_handle, point.data(), nullptr));
    wanted_scene_n.push_back(tactus_scene_force(scene.get(), point.data() + 2, nullptr));
  }
  std::atomic<int> different{0};
  std::vector<std::thread> readers;
  for (int t = 0; t < 8; ++t) {
    readers.emplace_back([&, t] {
      std::vector<double> forces(kPoints);
      for (int round = 0; round < 20; ++round) {
        for (std::size_t p = 0; p < kPoints; ++p) {
          const double* const point = points.data() + 4 * p;
          if (tactus_force(shared_handle, point, nullptr) != wanted_n[p]) ++different;
          if (tactus_scene_force(scene.get(), point + 2, nullptr) != wanted_scene_n[p]) ++different;
        }
        tactus_force_batch(shared_handle, points.data(), kPoints, forces.data(), nullptr);
        // Each thread has its own tube and scenes on the shared model.
        const auto own = support::ngtSceneHandle(shared_handle, 0.1 * t, 10.0 * t);
        const auto tube = support::tubeOf(own.get());
        tactus_feel feel = {};
        feel.size = sizeof feel;
        for (int i = 0; i < 50; ++i) tactus_tube_step(tube.get(), 0.05 * i, 1, 0.001, &feel);
      }
    });
  }
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(different, 0);
}

}  // namespace
}  // namespace tactus
