// Punctures: which share of the force is left where, and that it is lost once in a stroke.
#include "core/render/tube_events.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/render/tube_checks.h"

#include "tests/core/haptics/scenes.h"
#include "tests/core/render/pushed_tube.h"

namespace tactus::render {
namespace {

using Shape = fuzzy::Shape;

/// 1 N everywhere; a wall with its core from 22 to 30 mm, and a second, peaked one at 60 mm.
fuzzy::ForceModel twoWalls(fuzzy::RendererParameters renderer = undamped()) {
  fuzzy::ForceModel model = haptics::constantModel(1, renderer);
  model.inputs[0].terms.push_back({"wall", "Wall", Shape::kTrapezoid, {20, 22, 30, 32}});
  model.inputs[0].terms.push_back({"second", "Second", Shape::kTriangle, {50, 60, 64}});
  model.events = {{"wall", 0.6}, {"second", 0.25}};
  return model;
}

/// The same by hand, with the tip as deep as `deepest_mm` in the stroke.
double leftByHand(double deepest_mm, double at_mm) {
  const auto ramp = [](double from, double to, double x) { return (x - from) / (to - from); };
  const double wall = at_mm <= 20 || at_mm >= 32 ? 0
                      : at_mm < 22               ? ramp(20, 22, at_mm)
                      : at_mm <= 30              ? 1
                                                 : ramp(32, 30, at_mm);
  const double second = at_mm <= 50 || at_mm >= 64 ? 0 : at_mm < 60 ? ramp(50, 60, at_mm) : ramp(64, 60, at_mm);
  return (deepest_mm >= 30 ? 1 - 0.6 * wall : 1) * (deepest_mm >= 60 ? 1 - 0.25 * second : 1);
}

TEST(TubeEvents, TheShareThatIsLeftByHand) {
  const auto model = twoWalls();
  const TubeEvents events(model.inputs[0], model.events, 0);
  EXPECT_EQ(events.left(29.999, 25), 1) << "nothing is lost before the place";
  EXPECT_EQ(events.left(30, 25), 0.4);
  EXPECT_EQ(events.left(30, 21), 0.7);
  EXPECT_EQ(events.left(31, 31), 0.7);
  EXPECT_EQ(events.left(40, 40), 1) << "behind the wall the force is that of the region there";
  EXPECT_EQ(events.left(60, 60), 0.75) << "the place of a triangle is its peak";
  EXPECT_EQ(events.left(300, 25), 0.4);
  EXPECT_EQ(events.reached(29.999), 0U);
  EXPECT_EQ(events.reached(30), 1U);
  EXPECT_EQ(events.reached(60), 2U);
  EXPECT_EQ(TubeEvents().left(100, 50), 1);
}

TEST(TubeEvents, EventsAtOnePlaceTakeTheirSharesOneAfterTheOther) {
  fuzzy::Variable way{"depth", "Depth", "mm", 0, 20, {}};
  way.terms = {{"a", "A", Shape::kTrapezoid, {0, 0, 10, 12}}, {"b", "B", Shape::kGaussian, {8, 4}}};
  const std::array<fuzzy::TubeEvent, 2> list = {{{"a", 0.5}, {"b", 0.5}}};
  const TubeEvents events(way, list, 0);
  EXPECT_EQ(events.reached(8), 1U) << "the place of a Gaussian is its mean";
  EXPECT_EQ(events.left(10, 8), 0.25);
  EXPECT_DOUBLE_EQ(events.left(10, 10), 0.5 * (1 - 0.5 * std::exp(-0.125)));
}

TEST(TubeEvents, PlacesAreInTheUniverseAndCountTheOffset) {
  fuzzy::Variable way{"depth", "Depth", "mm", 5, 12, {}};
  way.terms = {{"last", "Last", Shape::kTrapezoid, {8, 9, 40, 50}}};
  const std::array<fuzzy::TubeEvent, 1> list = {{{"last", 0.5}}};
  // The end of the passage is the end of the core, and the tube gets as far as 12 - 0.1.
  const TubeEvents events(way, list, 0.1);
  EXPECT_EQ(events.reached(11.89), 0U);
  EXPECT_EQ(events.reached(12 - 0.1), 1U);
  EXPECT_EQ(events.left(11.9, 100), 0.5) << "deeper than the universe is its end";
  EXPECT_EQ(events.left(11.9, -100), 1);
}

/// The tip from `from_mm` on, by a slow hand that leads it by at most 4.6 mm.
void pushTo(PushedTube& tube, double depth_mm) {
  for (int i = 0; i < 60'000 && tube.source.state().depth_mm < depth_mm; ++i) tube.moveBy(0.01, 1);
  ASSERT_GE(tube.source.state().depth_mm, depth_mm);
}
void pullTo(PushedTube& tube, double depth_mm) {
  for (int i = 0; i < 60'000 && tube.source.state().depth_mm > depth_mm; ++i) tube.moveBy(-0.01, 1);
  ASSERT_LE(tube.source.state().depth_mm, depth_mm);
}
void pressAgain(PushedTube& tube) {
  tube.tick.enabled = false;
  tube.rest(40);
  tube.tick.enabled = true;
  tube.rest(1);
}

TEST(InsertionEvents, TheForceIsLostOnceInAStroke) {
  PushedTube tube(haptics::sceneOf(twoWalls(), {}));
  tube.rest(1);
  ASSERT_NO_FATAL_FAILURE(pushTo(tube, 29));
  EXPECT_EQ(tube.source.state().model_n, 1);
  ASSERT_NO_FATAL_FAILURE(pushTo(tube, 30));
  tube.rest(100);
  EXPECT_NEAR(tube.dynamicN(), leftByHand(30, tube.source.state().depth_mm), 1e-9);  // the tip still creeps
  EXPECT_LT(tube.dynamicN(), 0.75);
  // Back within the stroke: the hole stays.
  ASSERT_NO_FATAL_FAILURE(pullTo(tube, 26));
  tube.rest(100);
  EXPECT_NEAR(tube.dynamicN(), 0.4, kRounding);
  ASSERT_NO_FATAL_FAILURE(pushTo(tube, 31));
  tube.rest(100);
  EXPECT_NEAR(tube.dynamicN(), leftByHand(31, tube.source.state().depth_mm), 1e-9);  // the tip still creeps
  // The next stroke begins behind the wall: the hole stays.
  pressAgain(tube);
  EXPECT_NEAR(tube.dynamicN(), leftByHand(31, tube.source.state().depth_mm), 1e-9);  // the tip still creeps
  ASSERT_NO_FATAL_FAILURE(pullTo(tube, 25));
  tube.rest(100);
  EXPECT_NEAR(tube.dynamicN(), 0.4, kRounding);
  // The next one in front of it: there is a wall again, at the same depth, and it is passed again.
  pressAgain(tube);
  EXPECT_EQ(tube.dynamicN(), 1);
  ASSERT_NO_FATAL_FAILURE(pushTo(tube, 30));
  tube.rest(100);
  EXPECT_LT(tube.dynamicN(), 0.75);
}

TEST(InsertionEvents, APlacementBeginsWithTheEventsBehindItsDepthDone) {
  PushedTube tube(haptics::sceneOf(twoWalls(), {}));
  const auto placedAt = [&](double depth_mm) {
    tube.source.place(depth_mm);
    pressAgain(tube);
    return tube.dynamicN();
  };
  EXPECT_EQ(placedAt(29), 1);
  EXPECT_NEAR(placedAt(30), 0.4, kRounding);
  EXPECT_EQ(placedAt(25), 1) << "a new placement is a new passage";
  EXPECT_NEAR(placedAt(62), 1 - 0.25 * 0.5, kRounding);
}

TEST(InsertionEvents, TheLossIsNoKick) {
  PushedTube tube(haptics::sceneOf(twoWalls(), {}));
  tube.rest(1);
  ASSERT_NO_FATAL_FAILURE(pushTo(tube, 29.5));
  tube.largest_step_n = 0;
  ASSERT_NO_FATAL_FAILURE(pushTo(tube, 33));
  // 50 N/s within a millisecond, times the share of static friction.
  EXPECT_LE(tube.largest_step_n, 0.05 * 1.15 + 0.01);
  EXPECT_GT(tube.largest_step_n, 0.01);
}

TEST(InsertionEvents, AnotherModelInTheHandTakesTheEventsItHas) {
  PushedTube tube(haptics::sceneOf(twoWalls(), {}));
  tube.rest(1);
  ASSERT_NO_FATAL_FAILURE(pushTo(tube, 30));
  ASSERT_NO_FATAL_FAILURE(pullTo(tube, 27));
  tube.rest(100);
  EXPECT_NEAR(tube.dynamicN(), 0.4, kRounding);
  auto none = twoWalls();
  none.events.clear();
  tube.largest_step_n = 0;
  tube.take(haptics::sceneOf(none, {}));
  tube.rest(100);
  EXPECT_NEAR(tube.dynamicN(), 1, kRounding);
  EXPECT_LE(tube.largest_step_n, kCalmStepN);
  // And back: the tip has been behind the wall in this stroke.
  tube.take(haptics::sceneOf(twoWalls(), {}));
  tube.rest(100);
  EXPECT_NEAR(tube.dynamicN(), 0.4, kRounding);
}

/// At each tick of random hands: the force is that of the present question, and the spring returns only energy that the
/// hand has put in.
TEST(InsertionEvents, RandomHandsGetTheForceByHandAndNoEnergy) {
  base::Random random(36);
  int pressed_again_before = 0;
  for (int run = 0; run < 60; ++run) {
    SCOPED_TRACE(run);
    fuzzy::RendererParameters renderer = undamped(random.uniform(0.05, 1));
    renderer.depth_offset_mm = random.uniform(-5, 15);
    renderer.slew_n_s = random.uniform(5, 500);
    const auto scene = haptics::sceneOf(twoWalls(renderer), {});
    Insertion tube(1e3);
    tube.place(random.uniform(0, 40));
    InsertionTick tick;
    tick.active = true;
    tick.scene = scene.get();
    double speed_mm_s = 0;
    double deepest_mm = 0;
    double deepest_before_mm = 0;  // of the last stroke
    double taken = 0;
    for (int i = 0; i < 3000; ++i) {
      if (random.below(80) == 0) speed_mm_s = random.uniform(-120, 150);
      if (random.below(200) == 0) tick.enabled = random.below(4) != 0;
      tick.dt_s = random.below(30) == 0 ? 0.003 : 0.001;
      tick.position_mm += speed_mm_s * tick.dt_s;
      const RendererState before = tube.state();
      tube.tick(tick);
      const RendererState& state = tube.state();
      const bool was_released = before.phase == Phase::kReleased;
      const double tip_mm = before.depth_mm + renderer.depth_offset_mm;
      const bool pressed = was_released && state.phase != Phase::kReleased;
      pressed_again_before += pressed && deepest_before_mm >= 30 && tip_mm < 30;
      if (!was_released && state.phase == Phase::kReleased) deepest_before_mm = std::max(deepest_mm, tip_mm);
      deepest_mm = was_released ? tip_mm : std::max(deepest_mm, tip_mm);
      if (state.phase != Phase::kReleased) {
        ASSERT_TRUE(state.asked.has_value());
        ASSERT_EQ(state.asked->depth_mm, tip_mm) << i;
        ASSERT_NEAR(state.model_n, leftByHand(deepest_mm, std::clamp(tip_mm, 0.0, 600.0)), 1e-12) << i;
      }
      const double k = renderer.stiffness_n_mm;
      const double moved_mm = before.position_mm ? *state.position_mm - *before.position_mm : 0;
      if (!was_released) taken += k * before.stretch_mm * moved_mm + k * moved_mm * moved_mm / 2;
      ASSERT_GE(taken - k * state.stretch_mm * state.stretch_mm / 2, -1e-12 * (1 + taken)) << i;
    }
  }
  EXPECT_GE(pressed_again_before, 5) << "strokes that begin in front of a wall that was passed";
}

TEST(InsertionEvents, TheTracesPassEachEventInTwoStrokes) {
  const auto model = twoWalls();
  const auto inputs = tubeInputs(model);
  const auto compiled = fuzzy::compile(model);
  ASSERT_TRUE(inputs && compiled);
  auto traces = tubeTraces(model, *inputs);
  const auto without = [&] {
    auto other = model;
    other.events.clear();
    return tubeTraces(other, *inputs);
  }();
  ASSERT_EQ(traces.size(), without.size() + 2);
  for (std::size_t event = 0; event < 2; ++event) {
    const TubeTrace& trace = traces[without.size() + event];
    const double place_mm = event == 0 ? 30 : 60;
    SCOPED_TRACE(trace.name);
    EXPECT_EQ(trace.name, "puncture_" + std::to_string(event + 1));
    TubeRun run(model, *inputs, *compiled);
    // How often the place was passed inwards, by stroke.
    std::vector<int> passed(3);
    double before_mm = 0;
    double shallowest_mm[3] = {1e9, 1e9, 1e9};
    for (const TubeStep& step : trace.steps) {
      const auto felt = run.step(step);
      ASSERT_TRUE(felt);
      ASSERT_LE(felt->stroke, 2U);
      if (before_mm < place_mm && felt->depth_mm >= place_mm) ++passed[felt->stroke];
      if (passed[1] > 0) shallowest_mm[felt->stroke] = std::min(shallowest_mm[felt->stroke], felt->depth_mm);
      before_mm = felt->depth_mm;
    }
    EXPECT_EQ(passed, (std::vector<int>{0, 2, 1}));
    EXPECT_LT(shallowest_mm[1], place_mm - 1);
  }
}

}  // namespace
}  // namespace tactus::render
