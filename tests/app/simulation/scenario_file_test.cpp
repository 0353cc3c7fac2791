#include <gtest/gtest.h>
#include <string>

#include "app/simulation/scenario.h"

namespace tactus::simulation {
namespace {

std::string with(const std::string& members) {
  return R"({ "format": "tactus-scenario", "version": 1, )" + members + " }";
}

const std::string kMotion = R"("motion": [ { "do": "rest", "duration_s": 2 } ])";

std::string refusal(const std::string& text) {
  const auto scenario = parseScenario(text);
  return scenario ? "taken" : scenario.error().message();
}

TEST(ScenarioFile, ReadsEveryMember) {
  const auto scenario = parseScenario(with(R"(
    "name": "all", "seed": 7, "conditions": { "lubrication": 0.5 }, "start_depth_mm": 30, "duration_s": 9,
    "hand": { "preset": "arm", "stiffness_n_m": 200, "tremor_mm": 0.3, "tremor_hz": 9 },
    "device": { "mass_kg": 0.1, "count_mm": 0, "delay_s": 0.002, "dropped_share": 0.001, "longest_stall_ms": 9 },
    "enable": { "by": "latch", "release_zone_mm": -5, "start_zone_mm": 3 },
    "limits": { "expert": true, "guard_velocity": false },
    "motion": [ { "do": "press" }, { "do": "swing", "amplitude_mm": 15, "frequency_hz": 0.8, "duration_s": 4 },
                { "do": "strokes", "count": 2 } ],
    "events": [ { "at_s": 3, "fault": "stalled", "duration_s": 0.01 },
                { "at_s": 1, "conditions": { "lubrication": 1 }, "fade_s": 1, "model": "b.json" },
                { "at_s": 2, "source": "stimulus", "stimulus_n": 0.6, "armed": false, "stop": true,
                  "placement": true, "program_alive": false } ])"));
  ASSERT_TRUE(scenario) << scenario.error().message();
  EXPECT_EQ(scenario->name, "all");
  EXPECT_EQ(scenario->device.seed, 7u);
  EXPECT_EQ(scenario->conditions.at("lubrication"), 0.5);
  EXPECT_EQ(scenario->duration_s, 9);
  EXPECT_EQ(scenario->start_depth_mm, 30);
  EXPECT_EQ(scenario->device.hand.mass_kg, haptics::kArm.mass_kg);
  EXPECT_EQ(scenario->device.hand.stiffness_n_m, 200);
  EXPECT_EQ(scenario->tremor_hz, 9);
  EXPECT_EQ(scenario->device.mechanics.mass_kg, 0.1);
  EXPECT_EQ(scenario->device.count_mm, 0);
  EXPECT_EQ(scenario->device.delay_s, 0.002);
  EXPECT_EQ(scenario->enable.kind, haptics::EnableKind::kLatch);
  EXPECT_EQ(scenario->enable.start_zone_mm, 3);
  EXPECT_TRUE(scenario->expert_limits);
  EXPECT_FALSE(scenario->guard_velocity);
  EXPECT_EQ(scenario->motion.size(), 2u + 2 * 7);

  ASSERT_EQ(scenario->events.size(), 3u);
  EXPECT_EQ(scenario->events[0].model, "b.json");
  EXPECT_EQ(scenario->events[0].fade_s, 1);
  EXPECT_EQ(scenario->events[1].source, haptics::ForceSource::kStimulus);
  EXPECT_EQ(scenario->events[1].stimulus_n, 0.6);
  EXPECT_EQ(scenario->events[1].armed, false);
  EXPECT_EQ(scenario->events[1].program_alive, false);
  EXPECT_TRUE(scenario->events[1].stop && scenario->events[1].placement);
  ASSERT_EQ(scenario->device.faults.size(), 1u);
  EXPECT_EQ(scenario->device.faults[0].fault, haptics::InjectedFault::kStalled);
  EXPECT_EQ(scenario->device.faults[0].start_s, 3);
  EXPECT_EQ(scenario->device.faults[0].duration_s, 0.01);
}

TEST(ScenarioFile, TheDefaultsAreThoseOfTheVirtualDevice) {
  const auto scenario = parseScenario(with(kMotion));
  ASSERT_TRUE(scenario);
  const haptics::VirtualDeviceSettings device;
  EXPECT_EQ(scenario->device.hand.name, device.hand.name);
  EXPECT_EQ(scenario->device.count_mm, device.count_mm);
  EXPECT_EQ(scenario->duration_s, 2);
  EXPECT_EQ(scenario->events.size(), 0u);
}

TEST(ScenarioFile, SaysWhatWhereFoundAndWanted) {
  EXPECT_EQ(refusal("{ \"format\":\n \"tactus").substr(0, 6), "line 2");
  EXPECT_EQ(refusal("[]"), "found JSON that is not an object, wanted an object");
  EXPECT_EQ(refusal(R"({ "format": "tactus-model", "version": 1, "motion": [] })"),
            "/format: found the string 'tactus-model', wanted 'tactus-scenario'");
  EXPECT_EQ(refusal(R"({ "format": "tactus-scenario", "version": 2, "motion": [] })"),
            "/version: found version 2, newer than this program, wanted at most version 1");
  EXPECT_EQ(refusal(with(R"("name": "no motion")")), "found no key 'motion', wanted a key 'motion' with an array");
  EXPECT_EQ(refusal(with(R"("motion": [ { "do": "jump" } ])")),
            "/motion/0/do: found the string 'jump', wanted 'rest', 'stroke', 'go_to', 'push', 'swing', 'press', "
            "'release', 'let_go', 'hold' or 'strokes'");
  EXPECT_EQ(refusal(with(R"("motion": [ { "do": "push", "speed_mm_s": 5 } ])")),
            "/motion/0: found no key 'duration_s', wanted a key 'duration_s' with a number in [0.001, 3600]");
  EXPECT_EQ(refusal(with(R"("motion": [ { "do": "rest", "duration_s": 1, "length_mm": 5 } ])")),
            "/motion/0/length_mm: found an unknown key, wanted 'do' or 'duration_s'");
  EXPECT_EQ(refusal(with(R"("motion": [ { "do": "rest", "duration_s": -1 } ])")),
            "/motion/0/duration_s: found the number -1, wanted a number in [0.001, 3600]");
  EXPECT_EQ(refusal(with(kMotion + R"(, "device": { "delay_s": 5 })")),
            "/device/delay_s: found the number 5, wanted a number in [0, 0.1]");
  EXPECT_EQ(refusal(with(kMotion + R"(, "conditions": { "lubrication": "well" })")),
            "/conditions/lubrication: found the string 'well', wanted a number in [-1e+09, 1e+09]");
  EXPECT_EQ(refusal(with(kMotion + R"(, "conditions": { "lubrication": 1e400 })")),
            "/conditions/lubrication: found the number '1e400', wanted a number in the range of a double");
  EXPECT_EQ(refusal(with(kMotion + ", " + kMotion)), "/motion: found the key 'motion' twice, wanted each key once");
  EXPECT_NE(refusal(with(R"("motion": [])")), "taken");
}

TEST(ScenarioFile, HostileTextsCostNeitherStackNorMemory) {
  EXPECT_NE(refusal(with("\"motion\": " + std::string(500000, '['))), "taken");
  std::string motion = R"("motion": [ )";
  for (int i = 0; i < 20000; ++i) motion += R"({ "do": "strokes", "count": 1000 }, )";
  EXPECT_EQ(refusal(with(motion + R"({ "do": "press" } ])")),
            "/motion/14/do: found the string 'strokes', wanted at most 100000 steps in all");
}

TEST(ScenarioFile, AnEventWithoutEffectIsATypingError) {
  const auto event = [](const std::string& members) {
    return refusal(with(kMotion + R"(, "events": [ { )" + members + " } ]"));
  };
  EXPECT_EQ(event(R"("at_s": 0.5)"),
            "/events/0/at_s: found the number 0.5, wanted something that happens at this time");
  EXPECT_EQ(event(R"("at_s": 0.5, "stop": true, "fade_s": 1)"),
            "/events/0/fade_s: found the number 1, wanted conditions or a model that fade");
  EXPECT_EQ(event(R"("at_s": 0.5, "stop": true, "duration_s": 1)"),
            "/events/0/duration_s: found the number 1, wanted a fault that lasts");
  EXPECT_EQ(event(R"("at_s": 2, "stop": true)"), "/events/0/at_s: found 2 s, wanted a time before the end at 2 s");
}

}  // namespace
}  // namespace tactus::simulation
