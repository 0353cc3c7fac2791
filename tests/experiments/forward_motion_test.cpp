#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "experiments/stroke.h"

namespace tactus::experiments {
namespace {

TEST(ForwardMotion, WayAndSpeedOfASteadyPush) {
  ForwardMotion motion(10);
  for (int i = 0; i <= 1000; ++i) motion.add({i / 1000.0, 40.0 * i / 1000});
  EXPECT_NEAR(motion.wayMm(), 40, 1e-9);
  EXPECT_NEAR(motion.speedMmS(), 40, 1e-9);
}

TEST(ForwardMotion, PausesAndReturnsAreNoWay) {
  ForwardMotion motion(10);
  double position_mm = 0;
  for (int i = 0; i <= 3000; ++i) {
    motion.add({i / 1000.0, position_mm});
    // a second forward at 30 mm/s, a second of rest, a second back
    position_mm += i < 1000 ? 0.03 : i < 2000 ? 0 : -0.03;
  }
  EXPECT_NEAR(motion.wayMm(), 30, 1e-9);
  EXPECT_NEAR(motion.speedMmS(), 30, 1e-9);
}

TEST(ForwardMotion, TremorAndCreepingAreNoWay) {
  for (const double hz : {8.0, 9.7, 12.0}) {
    ForwardMotion tremor(10);
    for (int i = 0; i <= 5000; ++i) tremor.add({i / 1000.0, 0.3 * std::sin(2 * std::numbers::pi * hz * i / 1000)});
    EXPECT_EQ(tremor.wayMm(), 0) << hz;
  }
  ForwardMotion creeping(10);
  for (int i = 0; i <= 5000; ++i) creeping.add({i / 1000.0, 9.0 * i / 1000});
  EXPECT_EQ(creeping.wayMm(), 0);
  EXPECT_EQ(creeping.speedMmS(), 0);
}

TEST(ForwardMotion, SamplesThatCannotBeAreLeftOut) {
  ForwardMotion motion(10);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  motion.add({nan, 0});
  for (int i = 0; i <= 200; ++i) {
    motion.add({i / 1000.0, 20.0 * i / 1000});
    motion.add({i / 1000.0, 500});
    motion.add({1.0, nan});
  }
  EXPECT_NEAR(motion.wayMm(), 4, 1e-9);
}

}  // namespace
}  // namespace tactus::experiments
