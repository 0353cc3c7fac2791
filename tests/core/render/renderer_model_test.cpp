// When the model is asked, what happens where no rule fires, at the ends of the passage, and with faults.
#include <gtest/gtest.h>
#include <limits>

#include "core/render/insertion_renderer.h"

#include "tests/core/render/scripted_tube.h"

namespace tactus::render {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(RendererQuestions, NoneWhileReleasedOneWhileStuck) {
  ScriptedTube tube;
  tube.held = false;
  tube.moveTo(30, 100);
  EXPECT_EQ(tube.questions, 0);
  tube.held = true;
  tube.moveTo(31, 500);
  EXPECT_EQ(tube.questions, 1);
  EXPECT_EQ(tube.last_question, (ForcePoint{0, 0}));
}

TEST(RendererQuestions, OneMoreWhenTheConditionsChange) {
  ScriptedTube tube;
  tube.moveTo(1, 100);
  ++tube.conditions;
  tube.model.force_n = 0.7;
  tube.tick(1);
  EXPECT_EQ(tube.questions, 2);
  EXPECT_EQ(tube.state.model_n, 0.7);
  tube.moveTo(1.2, 100);
  EXPECT_EQ(tube.questions, 2);
}

TEST(RendererQuestions, EachTickWhileSlidingIn) {
  ScriptedTube tube;
  tube.moveTo(10, 200);
  const int before = tube.questions;
  tube.moveTo(15, 100);
  EXPECT_EQ(tube.questions, before + 100);
  EXPECT_NEAR(tube.last_question.speed_mm_s, 50, 1e-3);  // the filter has had 15 time constants
}

TEST(RendererQuestions, AskAtTheDepthOfTheModelAndWithoutSpeedOnWithdrawal) {
  ScriptedTube tube;
  tube.settings.friction.depth_offset_mm = -12;
  tube.state.depth_mm = 100;
  tube.moveTo(-20, 200);
  const double depth_mm = tube.state.depth_mm;
  tube.tick(-20.1);
  EXPECT_EQ(tube.last_question, (ForcePoint{depth_mm - 12, 0}));
}

TEST(RendererQuestions, StayOpenUntilAnswered) {
  ScriptedTube tube;
  tube.moveTo(1, 100);
  const RendererInput input{1, true, 5, {}};
  EXPECT_TRUE(forceNeeded(tube.state, input, tube.settings));
  const RendererState next = step(tube.state, input, tube.settings, 0.001);
  EXPECT_EQ(next.model_n, 0.4);
  EXPECT_TRUE(forceNeeded(next, input, tube.settings));
}

TEST(RendererHole, HoldsTheLastForceThatFiredAndSaysSo) {
  ScriptedTube tube;
  tube.moveTo(10, 200);
  tube.model = {0.05, false};
  tube.moveTo(20, 200);
  EXPECT_TRUE(tube.state.held);
  EXPECT_NEAR(tube.state.force_n, 0.4, 1e-9);
  tube.model = {0.3, true};
  tube.moveTo(30, 200);
  EXPECT_FALSE(tube.state.held);
  EXPECT_NEAR(tube.state.force_n, 0.3, 1e-9);
}

TEST(RendererHole, BeforeAnyRuleFiredTheModelsDefaultHolds) {
  ScriptedTube tube;
  tube.model = {0.1, false};
  tube.moveTo(10, 200);
  EXPECT_TRUE(tube.state.held);
  EXPECT_NEAR(tube.state.force_n, 0.1, 1e-9);
}

TEST(RendererEnds, TubeStopsAtTheEndOfThePassageAndHolds) {
  ScriptedTube tube;
  tube.settings.depth_end_mm = 105;
  tube.settings.friction.depth_offset_mm = 5;
  tube.state.depth_mm = 90;
  tube.moveTo(40, 400);
  EXPECT_EQ(tube.state.depth_mm, 100);
  EXPECT_EQ(tube.state.phase, Phase::kStuck);
  tube.moveTo(60, 1000);
  EXPECT_EQ(tube.state.depth_mm, 100);
  EXPECT_NEAR(tube.state.force_n, 0.46, 1e-5);  // F_m, after ten times the ageing time
  tube.moveTo(50, 200);
  EXPECT_NEAR(tube.state.depth_mm, 100 - 10 + (0.46 + 0.24) / 0.25, 1e-4);
}

TEST(RendererEnds, TubeThatIsOutHasNoResistance) {
  ScriptedTube tube;
  tube.state.depth_mm = 5;
  tube.moveTo(-30, 300);
  EXPECT_EQ(tube.state.depth_mm, 0);
  EXPECT_NEAR(tube.state.force_n, 0, 1e-6);
  tube.moveTo(-29, 100);
  EXPECT_NEAR(tube.state.force_n, 0.25, 1e-6);
}

TEST(RendererFault, LatchesUntilTheHandLetsGo) {
  for (const Fault fault : {Fault::kPosition, Fault::kForce, Fault::kTime}) {
    ScriptedTube tube;
    tube.moveTo(10, 200);
    if (fault == Fault::kForce) tube.model.force_n = kNan;
    if (fault == Fault::kTime) tube.dt_s = 0;
    tube.tick(fault == Fault::kPosition ? kNan : 10.1);
    EXPECT_EQ(tube.state.fault, fault);
    EXPECT_EQ(tube.state.phase, Phase::kReleased);
    tube.model.force_n = 0.4;
    tube.dt_s = 0.001;
    for (int i = 0; i < 100; ++i) tube.tick(12);
    EXPECT_NEAR(tube.state.force_n, 0, 1e-12);
    EXPECT_EQ(tube.state.fault, fault) << "still pressed";
    tube.held = false;
    tube.tick(12);
    EXPECT_EQ(tube.state.fault, Fault::kNone);
    tube.held = true;
    tube.tick(12);
    EXPECT_EQ(tube.state.phase, Phase::kStuck);
  }
}

TEST(RendererCap, TubeSlipsAtTheCap) {
  ScriptedTube tube;
  tube.settings.force_cap_n = 0.3;
  tube.moveTo(10, 200);
  EXPECT_NEAR(tube.state.force_n, 0.3, 1e-12);
  EXPECT_NEAR(tube.state.depth_mm, 10 - 0.3 / 0.25, 1e-9);
}

}  // namespace
}  // namespace tactus::render
