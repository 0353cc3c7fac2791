#include "core/haptics/simulated/hand_plan.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace tactus::haptics {
namespace {

TEST(HandPlan, StrokeIsOfMinimumJerk) {
  // Flash and Hogan 1985: half the way at half the time, there at 1.875 A/D; at a quarter 0.103516 of the way.
  const HandPlan plan = stroke(60, 0.8);
  EXPECT_EQ(plan(0), (HandTarget{0, 0}));
  EXPECT_NEAR(plan(0.2).position_mm, 60 * 0.103515625, 1e-12);
  EXPECT_NEAR(plan(0.4).position_mm, 30, 1e-12);
  EXPECT_NEAR(plan(0.4).speed_mm_s, 1.875 * 60 / 0.8, 1e-12);
  EXPECT_NEAR(plan(0.8).position_mm, 60, 1e-12);
  EXPECT_EQ(plan(7).speed_mm_s, 0);
}

TEST(HandPlan, SpeedsAreTheSlopesOfPositions) {
  const HandPlan plans[] = {stroke(60, 0.8),
                            push(5),
                            swing(0.3, 10),
                            swing(15, 0.8),
                            strokes({.count = 2}),
                            after(0.1, stroke(40, 0.5)),
                            both(push(20), swing(0.3, 10))};
  constexpr double kHalf = 1e-5;
  for (const HandPlan& plan : plans) {
    for (double time_s = 0.0131; time_s < 4.5; time_s += 0.0173) {
      const double slope = (plan(time_s + kHalf).position_mm - plan(time_s - kHalf).position_mm) / (2 * kHalf);
      // The third derivative is at most 60 A/D³ = 19200 (stroke) and a ω³ = 74000 mm/s³ (tremor): times h²/6 1.3e-6.
      // Rounding of 60 mm over 2 h: 1e-9.
      EXPECT_NEAR(plan(time_s).speed_mm_s, slope, 2e-6) << time_s;
    }
  }
}

TEST(HandPlan, StrokesPressPushReleaseAndComeBack) {
  const StrokeSeries series{
      .count = 3, .length_mm = 60, .settle_s = 0.1, .forward_s = 0.8, .hold_s = 0.3, .back_s = 0.6, .pause_s = 0.2};
  EXPECT_NEAR(series.periodS(), 2.0, 1e-12);
  const HandPlan plan = strokes(series);
  for (const double begin_s : {0.0, 2.0, 4.0}) {
    EXPECT_EQ(plan(begin_s + 0.05).position_mm, 0);
    EXPECT_TRUE(plan(begin_s + 0.05).button);
    EXPECT_NEAR(plan(begin_s + 0.5).position_mm, 30, 1e-9);
    EXPECT_NEAR(plan(begin_s + 1.1).position_mm, 60, 1e-9);
    EXPECT_TRUE(plan(begin_s + 1.1).button);
    EXPECT_FALSE(plan(begin_s + 1.21).button);
    EXPECT_NEAR(plan(begin_s + 1.5).position_mm, 30, 1e-9);
    EXPECT_NEAR(plan(begin_s + 1.5).speed_mm_s, -1.875 * 60 / 0.6, 1e-9);
    EXPECT_NEAR(plan(begin_s + 1.9).position_mm, 0, 1e-9);
    EXPECT_FALSE(plan(begin_s + 1.9).button);
  }
  EXPECT_EQ(plan(6.05), HandTarget{});
}

TEST(HandPlan, CombinationsAddWaysAndShareTheHold) {
  const HandPlan shaky = both(push(10), lettingGo(pressing(swing(2, 1), 0.1, 0.9), 0.6));
  // The plans have a sine of their own, so that they have the same bits on every machine.
  EXPECT_NEAR(shaky(0.05).position_mm, 0.5 + 2 * std::sin(2 * std::numbers::pi * 0.05), 1e-14);
  EXPECT_NEAR(shaky(0.05).speed_mm_s, 10 + 4 * std::numbers::pi * std::cos(2 * std::numbers::pi * 0.05), 1e-13);
  EXPECT_TRUE(shaky(0.1).button);
  EXPECT_TRUE(shaky(0.59).holds);
  EXPECT_FALSE(shaky(0.6).holds);
  EXPECT_FALSE(shaky(0.6).button);
  EXPECT_FALSE(pressing(push(1), 0.1, 0.9)(0.9).button);
  EXPECT_TRUE(pressing(push(1))(100).button);
}

TEST(HandPlan, AfterRestsWhereThePlanBegins) {
  const HandPlan plan = after(1, pressing(both(stroke(10, 1), swing(3, 1))));
  EXPECT_EQ(plan(0.5), HandTarget{});
  EXPECT_TRUE(plan(1.25).button);
  EXPECT_NEAR(plan(1.25).position_mm, 10 * 0.103515625 + 3, 1e-12);
}

}  // namespace
}  // namespace tactus::haptics
