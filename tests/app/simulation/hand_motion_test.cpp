#include <gtest/gtest.h>

#include "app/simulation/scenario.h"

namespace tactus::simulation {
namespace {

using Kind = MotionStep::Kind;

TEST(HandMotion, EachStepBeginsWhereTheOneBeforeEnded) {
  const auto plan = planOf({{.kind = Kind::kRest, .duration_s = 1},
                            {.kind = Kind::kPress},
                            {.kind = Kind::kStroke, .duration_s = 2, .length_mm = 40},
                            {.kind = Kind::kPush, .duration_s = 3, .speed_mm_s = 5},
                            {.kind = Kind::kRelease},
                            {.kind = Kind::kGoTo, .duration_s = 1, .position_mm = 10}});
  EXPECT_EQ(plan(0.5), (haptics::HandTarget{0, 0, true, false}));
  // Halfway a minimum-jerk movement is halfway, at 1.875 times its mean speed.
  EXPECT_EQ(plan(2), (haptics::HandTarget{20, 37.5, true, true}));
  EXPECT_EQ(plan(4), (haptics::HandTarget{45, 5, true, true}));
  EXPECT_EQ(plan(6.5), (haptics::HandTarget{32.5, -45 * 1.875, true, false}));
  EXPECT_EQ(plan(100), (haptics::HandTarget{10, 0, true, false}));
}

TEST(HandMotion, LettingGoAndHoldingAgainTakeNoTime) {
  const auto plan = planOf({{.kind = Kind::kPress},
                            {.kind = Kind::kRest, .duration_s = 1},
                            {.kind = Kind::kLetGo},
                            {.kind = Kind::kRest, .duration_s = 1},
                            {.kind = Kind::kHold},
                            {.kind = Kind::kRest, .duration_s = 1}});
  EXPECT_TRUE(plan(0.999).holds);
  EXPECT_FALSE(plan(1).holds);
  EXPECT_TRUE(plan(1).button);
  EXPECT_TRUE(plan(2).holds);
}

TEST(HandMotion, StrokesSpelledOutAreTheStrokesOfTheLibrary) {
  const haptics::StrokeSeries series{.count = 3};
  const auto steps = spelledOut(series);
  const auto ours = planOf(steps);
  const auto theirs = haptics::strokes(series);
  EXPECT_NEAR(durationS(steps), 3 * series.periodS(), 1e-12);
  for (int i = 0; i < 6500; ++i) {
    const double time_s = 1e-3 * i + 0.0005;  // beside the edges, where sums of durations may differ by an ulp
    EXPECT_NEAR(ours(time_s).position_mm, theirs(time_s).position_mm, 1e-9) << time_s;
    EXPECT_EQ(ours(time_s).button, theirs(time_s).button) << time_s;
  }
}

}  // namespace
}  // namespace tactus::simulation
