#include "app/simulation/scenario_run.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/fuzzy/compiled_model.h"

#include "tests/support/ngt_model.h"

namespace tactus::simulation {
namespace {

Scenario scenario(const std::string& members) {
  auto read = parseScenario(R"({ "format": "tactus-scenario", "version": 1,
      "conditions": { "lubrication": 1, "neck_flexion": 45 }, )" +
                            members + " }");
  EXPECT_TRUE(read) << read.error().message();
  return std::move(*read);
}

base::Result<fuzzy::ForceModel> noOther(const std::string& path) {
  return base::fail(base::ErrorCode::kIo, path, "no file", "a model file");
}

struct Run {
  std::vector<TraceTick> ticks;
  RunSummary summary;
  std::string text;
};

Run run(const Scenario& scenario, const ReadModel& other = noOther) {
  Run out;
  TraceTable table(scenario.conditions);
  const auto summary = runScenario(scenario, support::s4FiveRegions(), other, [&](const TraceTick& tick) {
    out.ticks.push_back(tick);
    table.add(tick);
  });
  EXPECT_TRUE(summary) << summary.error().message();
  if (summary) out.summary = *summary;
  out.text = table.text();
  return out;
}

const std::string kTenStrokes =
    R"("motion": [ { "do": "rest", "duration_s": 1.2 }, { "do": "strokes", "count": 10 } ])";

TEST(ScenarioRun, TenStrokesPushTheTubeInAsFarAsTheHandWentLessTheGive) {
  const auto [ticks, summary, text] = run(scenario(kTenStrokes));
  EXPECT_EQ(summary.strokes, 10);
  EXPECT_NEAR(summary.planned_mm, 600, 1e-6);
  EXPECT_TRUE(summary.trips.empty());
  // Each stroke first stretches the spring by F_m / k and the hand by F / 100 N/m: with at most 0.5 N no more than 9
  // mm.
  EXPECT_GT(summary.depth_mm, 600 - 10 * 9);
  EXPECT_LT(summary.depth_mm, 600);

  // Within a stroke, after the anchor, the tube advances as the hand does less the stretch: to one count of the device.
  double start_mm = 0, start_depth_mm = 0;
  std::uint32_t stroke = 0;
  for (const auto& tick : ticks) {
    const auto& s = tick.sample;
    if (s.phase == render::Phase::kReleased) continue;
    if (s.stroke != stroke) {
      stroke = s.stroke;
      start_mm = s.position_mm;
      start_depth_mm = s.depth_mm;
    }
    ASSERT_NEAR(s.depth_mm - start_depth_mm, s.position_mm - start_mm - s.stretch_mm, 0.055) << 1e-9 * s.time_ns;
  }
}

TEST(ScenarioRun, WhileSlidingSlowlyTheForceIsTheModelsAtTheDepth) {
  const auto [ticks, summary, text] = run(scenario(
      R"("hand": { "preset": "arm" }, "motion": [ { "do": "rest", "duration_s": 1.2 }, { "do": "press" },
         { "do": "push", "speed_mm_s": 30, "duration_s": 3 } ])"));
  const auto model = fuzzy::compile(support::s4FiveRegions());
  ASSERT_TRUE(model);
  int compared = 0;
  for (std::size_t i = 3000; i < ticks.size(); ++i) {
    const auto& s = ticks[i].sample;
    const auto& before = ticks[i - 1].sample;
    if (s.phase != render::Phase::kSlidingIn || before.phase != render::Phase::kSlidingIn) continue;
    const double inputs[] = {1, 45, before.depth_mm, before.slip_speed_mm_s};  // the point that this tick asked for
    EXPECT_NEAR(s.model_force_n, model->evaluate(inputs).force_n, 1e-12) << i;
    // The force follows within a count of the spring: 0.055 mm x 0.25 N/mm = 0.014 N.
    EXPECT_NEAR(s.force_n, s.model_force_n, 0.015) << i;
    ++compared;
  }
  EXPECT_GT(compared, 500);
}

TEST(ScenarioRun, TheSameScenarioGivesTheSameBytes) {
  const auto text =
      R"("seed": 3, "device": { "dropped_share": 0.01, "stalls_per_s": 2 }, "hand": { "tremor_mm": 0.3 }, )" +
      kTenStrokes;
  EXPECT_EQ(run(scenario(text)).text, run(scenario(text)).text);
  EXPECT_NE(run(scenario(text)).text,
            run(scenario(R"("seed": 4, "device": { "dropped_share": 0.01 }, )" + kTenStrokes)).text);
}

TEST(ScenarioRun, EventsActAtTheirTick) {
  auto stiff = support::s4FiveRegions();
  for (auto& rule : stiff.experts[0].rules) rule.then = "very_large";
  const auto [ticks, summary, text] =
      run(scenario(R"("motion": [ { "do": "rest", "duration_s": 1.2 }, { "do": "press" },
                      { "do": "push", "speed_mm_s": 40, "duration_s": 3 } ],
                      "events": [ { "at_s": 2.5, "model": "stiff" }, { "at_s": 3.5, "stop": true } ])"),
          [&](const std::string& path) -> base::Result<fuzzy::ForceModel> {
            EXPECT_EQ(path, "stiff");
            return stiff;
          });
  EXPECT_EQ(ticks[2499].sample.orders, 0u);
  EXPECT_EQ(ticks[2500].sample.orders, 1u);
  EXPECT_GT(ticks[3400].sample.force_n, ticks[2499].sample.force_n + 0.2);
  ASSERT_EQ(summary.trips.size(), 1u);
  EXPECT_EQ(summary.trips[0].trip.cause, haptics::TripCause::kStopped);
  EXPECT_NEAR(summary.trips[0].at_s, 3.5, 1e-9);
  EXPECT_EQ(ticks[3700].sample.force_n, 0);
  // Nothing kicks the hand: the slew limit of any force, 250 N/s, but for what Stop takes away.
  for (std::size_t i = 1; i < 3500; ++i)
    EXPECT_LE(std::abs(ticks[i].sample.force_n - ticks[i - 1].sample.force_n), 0.25 + 1e-12) << i;
}

TEST(ScenarioRun, AnUnpluggedDeviceTripsAndASilentProgramOnlyTakesTheForceAway) {
  const std::string motion = R"("motion": [ { "do": "rest", "duration_s": 1.2 }, { "do": "press" },
      { "do": "push", "speed_mm_s": 40, "duration_s": 3 } ], "events": )";
  const auto unplugged = run(scenario(motion + R"([ { "at_s": 2, "fault": "unplugged" } ])"));
  ASSERT_EQ(unplugged.summary.trips.size(), 1u);
  EXPECT_EQ(unplugged.summary.trips[0].trip.cause, haptics::TripCause::kDeviceLost);
  EXPECT_NEAR(unplugged.summary.trips[0].at_s, 2, 0.0025);
  const auto silent = run(scenario(motion + R"([ { "at_s": 2, "program_alive": false } ])"));
  EXPECT_TRUE(silent.summary.trips.empty());
  EXPECT_GT(silent.ticks[2300].sample.force_n, 0.05);
  EXPECT_EQ(silent.ticks[3000].sample.force_n, 0);
}

TEST(ScenarioRun, SeveralEventsAtOneTimeAreAsOneEvent) {
  const std::string motion = R"("motion": [ { "do": "rest", "duration_s": 1.2 }, { "do": "press" },
      { "do": "push", "speed_mm_s": 40, "duration_s": 2 } ], "events": )";
  const auto change = [](double flexion_deg) {
    return R"({ "at_s": 2, "conditions": { "neck_flexion": )" + std::to_string(flexion_deg) + " } }";
  };
  const auto one = run(scenario(motion + "[" + change(80) + "]"));
  const auto four =
      run(scenario(motion + "[" + change(0) + "," + change(20) + "," + change(60) + "," + change(80) + "]"));
  ASSERT_EQ(one.ticks.size(), four.ticks.size());
  for (std::size_t i = 0; i < one.ticks.size(); ++i)
    ASSERT_EQ(one.ticks[i].sample.force_n, four.ticks[i].sample.force_n) << i;
}

TEST(ScenarioRun, AProgramThatIsDeadFromTheStartGivesNoForceAfterHalfASecond) {
  const auto dead = run(scenario(R"("motion": [ { "do": "rest", "duration_s": 0.1 }, { "do": "press" },
      { "do": "push", "speed_mm_s": 40, "duration_s": 2 } ], "events": [ { "at_s": 0, "program_alive": false } ])"));
  EXPECT_GT(dead.summary.largest_force_n, 0);
  for (std::size_t i = 600; i < dead.ticks.size(); ++i) ASSERT_EQ(dead.ticks[i].sample.force_n, 0) << i;
}

TEST(ScenarioRun, WithdrawalCountsAsForceToo) {
  const auto back = run(scenario(R"("start_depth_mm": 200, "motion": [ { "do": "rest", "duration_s": 0.1 },
      { "do": "press" }, { "do": "rest", "duration_s": 1.1 }, { "do": "stroke", "length_mm": -40, "duration_s": 1 } ])"));
  EXPECT_GT(back.summary.largest_force_n, 0.05);
}

TEST(ScenarioRun, ARefusedEventIsNamed) {
  const auto summary = runScenario(scenario(R"("motion": [ { "do": "rest", "duration_s": 1 } ],
                  "events": [ { "at_s": 0.5, "conditions": { "lube": 1 } } ])"),
                                   support::s4FiveRegions(), noOther, [](const TraceTick&) {});
  ASSERT_FALSE(summary);
  EXPECT_NE(summary.error().message().find("for /events/0 of the scenario"), std::string::npos)
      << summary.error().message();
}

TEST(ScenarioRun, RefusesAModelWhoseConditionsAreNotGiven) {
  auto few = scenario(kTenStrokes);
  few.conditions.erase("neck_flexion");
  const auto summary = runScenario(few, support::s4FiveRegions(), noOther, [](const TraceTick&) {});
  ASSERT_FALSE(summary);
  EXPECT_NE(summary.error().message().find("neck_flexion"), std::string::npos) << summary.error().message();
}

}  // namespace
}  // namespace tactus::simulation
