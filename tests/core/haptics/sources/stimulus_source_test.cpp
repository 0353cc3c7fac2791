#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/haptics/sources/force_source.h"

#include "tests/core/haptics/loop_numbers.h"

namespace tactus::haptics {
namespace {

/// Ticks of 1 ms.
struct Judging {
  StimulusSource source;
  Stimulus stimulus;
  LimitSettings limits;
  StimulusTick tick;
  double force_n = 0;
  double largest_step_n = 0;

  explicit Judging(double force) {
    stimulus.number = 1;
    stimulus.force_n = force;
    tick.active = tick.enabled = true;
  }

  void step(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) {
      const double before_n = force_n;
      force_n = source.tick(tick, stimulus, limits);
      largest_step_n = std::max(largest_step_n, std::abs(force_n - before_n));
    }
  }
};

TEST(StimulusSource, RisesEvenlyWithinItsRamp) {
  Judging judging(0.6);
  for (int i = 1; i <= 150; ++i) {
    EXPECT_EQ(judging.source.sinceFullS(), 0);
    judging.step();
    EXPECT_NEAR(judging.force_n, 0.6 * i / 150, kRounding);
    EXPECT_EQ(judging.source.phase(), i < 150 ? StimulusPhase::kRising : StimulusPhase::kFull);
  }
  judging.step(2000);
  EXPECT_EQ(judging.force_n, 0.6);
  EXPECT_NEAR(judging.source.sinceFullS(), 2, kRounding);
}

TEST(StimulusSource, WaitsForTheHandInsideTheStartZone) {
  Judging judging(0.6);
  judging.stimulus.start_zone_mm = 5;
  judging.tick.position_mm = -5.1;
  judging.step(100);
  EXPECT_EQ(judging.source.phase(), StimulusPhase::kWaiting);
  judging.tick.enabled = false;
  judging.tick.position_mm = 4;
  judging.step(100);
  EXPECT_EQ(judging.force_n, 0);
  judging.tick.enabled = true;
  judging.step(1);
  EXPECT_GT(judging.force_n, 0);
  // Only the start is bound to the zone: judging takes a way forward.
  judging.tick.position_mm = 60;
  judging.step(200);
  EXPECT_EQ(judging.force_n, 0.6);
}

TEST(StimulusSource, NumbersInARowDoNotDelayTheFade) {
  Judging judging(0.9);
  judging.step(200);
  judging.stimulus.start_zone_mm = 5;
  judging.tick.position_mm = 60;  // none of those that follow begins
  judging.largest_step_n = 0;
  for (int i = 0; i < 30; ++i) {
    if (i % 5 == 0) ++judging.stimulus.number;
    judging.step();
  }
  EXPECT_NEAR(judging.force_n, 0, kRounding);
  EXPECT_LE(judging.largest_step_n, 0.9 / 30 + kRounding);
}

TEST(StimulusSource, EndsAfterItsHoldLimit) {
  Judging judging(0.6);
  judging.stimulus.hold_limit_s = 2;
  judging.step(150 + 2000 - 1);
  EXPECT_EQ(judging.force_n, 0.6);
  judging.step(1);
  for (int i = 1; i <= 150; ++i) {
    EXPECT_NEAR(judging.force_n, 0.6 * (150 - i) / 150, kRounding);
    EXPECT_EQ(judging.source.phase(), i < 150 ? StimulusPhase::kFalling : StimulusPhase::kEnded);
    judging.step(1);
  }
  judging.step(1000);
  EXPECT_EQ(judging.force_n, 0);
  // The answer that comes later still knows its response time.
  EXPECT_NEAR(judging.source.sinceFullS(), 3.15, 1e-9);
}

TEST(StimulusSource, AboveTheContinuousRatingTheLimitsBoundTheHold) {
  Judging weak(0.88);
  weak.step(150 + 10000);
  EXPECT_EQ(weak.force_n, 0.88);
  for (const double asked_s : {0.5, 3.0, 10.0}) {
    Judging strong(1.7);
    strong.stimulus.hold_limit_s = asked_s;
    strong.step(149 + static_cast<int>(std::lround(1000 * std::min(asked_s, 3.0))));
    EXPECT_EQ(strong.force_n, 1.7);
    strong.step(151);
    EXPECT_EQ(strong.force_n, 0);
  }
}

TEST(StimulusSource, LettingGoEndsItForGood) {
  Judging judging(1.2);
  judging.step(300);
  judging.largest_step_n = 0;
  judging.tick.enabled = false;
  judging.step(30);
  EXPECT_NEAR(judging.force_n, 0, kRounding);
  EXPECT_LE(judging.largest_step_n, 1.2 / 30 + kRounding);
  judging.tick.enabled = true;
  judging.step(500);
  EXPECT_EQ(judging.force_n, 0);
  EXPECT_EQ(judging.source.phase(), StimulusPhase::kEnded);
  judging.stimulus.number = 2;
  judging.step(150);
  EXPECT_EQ(judging.force_n, 1.2);
}

TEST(StimulusSource, AnotherNumberStartsAnewBesideTheRestOfTheFirst) {
  Judging judging(0.6);
  judging.step(300);
  judging.largest_step_n = 0;
  judging.stimulus.number = 2;
  judging.stimulus.force_n = 0.9;
  judging.step(1);
  EXPECT_EQ(judging.source.phase(), StimulusPhase::kRising);
  EXPECT_EQ(judging.source.sinceFullS(), 0);
  EXPECT_NEAR(judging.force_n, 0.6 * 29 / 30 + 0.9 / 150, kRounding);
  judging.step(149);
  EXPECT_EQ(judging.force_n, 0.9);
  EXPECT_LE(judging.largest_step_n, 0.6 / 30 + kRounding);
}

TEST(StimulusSource, WithoutAnotherNumberNothingChangesIt) {
  Judging judging(0.6);
  judging.step(100);
  judging.stimulus.force_n = 1.5;
  judging.stimulus.ramp_s = 1;
  judging.step(100);
  EXPECT_EQ(judging.force_n, 0.6);
}

TEST(StimulusSource, AnotherSourceEndsIt) {
  Judging judging(0.6);
  judging.step(300);
  judging.tick.active = false;
  judging.step(30);
  EXPECT_NEAR(judging.force_n, 0, kRounding);
  judging.tick.active = true;
  judging.step(300);
  EXPECT_EQ(judging.force_n, 0);
}

TEST(StimulusSource, ABlankRunsThroughTheSameStages) {
  Judging judging(0);
  judging.stimulus.hold_limit_s = 1;
  judging.step(150);
  EXPECT_EQ(judging.source.phase(), StimulusPhase::kFull);
  judging.step(1150);
  EXPECT_EQ(judging.source.phase(), StimulusPhase::kEnded);
  EXPECT_EQ(judging.largest_step_n, 0);
}

TEST(StimulusSource, AForceThatIsNoneIsLeftToTheSafetyLayer) {
  Judging judging(std::numeric_limits<double>::quiet_NaN());
  judging.step(1);
  EXPECT_TRUE(std::isnan(judging.force_n));
  judging.tick.enabled = false;
  judging.step(1);
  EXPECT_EQ(judging.force_n, 0);
}

}  // namespace
}  // namespace tactus::haptics
