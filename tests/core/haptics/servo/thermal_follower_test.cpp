#include <gtest/gtest.h>

#include "core/haptics/servo/loop_statistics.h"

#include "tests/core/haptics/safety/safety_loop.h"

namespace tactus::haptics {
namespace {

Sample sampleOf(const SafetyLoop& loop) {
  Sample sample;
  sample.time_ns = loop.now_ns;
  sample.force_n = loop.out.force_n;
  return sample;
}

TEST(ThermalFollower, KnowsWhatTheServoKnows) {
  SafetyLoop loop;
  ThermalFollower follower;
  for (int i = 0; i < 40'000; ++i) {
    loop.input.armed = i >= 2;
    loop.press(i >= 4);
    loop.asked_n = i % 6000 < 3000 ? 1.7 : 0;
    loop.tick();
    follower.add(sampleOf(loop), loop.limits);
  }
  EXPECT_GT(loop.safety.thermalShare(), 0.8);
  EXPECT_EQ(follower.budget().share(), loop.safety.thermalShare());
}

// 1.7 N for 2 s are 5.78 N²s of 46.464 N²s.
TEST(ThermalFollower, AGapCountsForTwoSecondsOfTheLastForce) {
  ThermalFollower follower;
  const LimitSettings limits;
  Sample sample;
  sample.time_ns = 1'000'000'000;
  sample.force_n = 1.7;
  follower.add(sample, limits);
  sample.time_ns += 30'000'000'000;
  sample.force_n = 0;
  follower.add(sample, limits);
  EXPECT_NEAR(follower.budget().share(), 5.78 / 46.464, 1e-9);
}

}  // namespace
}  // namespace tactus::haptics
