#include <algorithm>
#include <cmath>

#include "app/simulation/json_reading.h"
#include "app/simulation/scenario.h"
#include "core/base/file.h"
#include "core/base/text.h"

namespace tactus::simulation {
namespace {

using base::ErrorCode;
using Kind = MotionStep::Kind;
using Problem = std::optional<base::Error>;

constexpr Range kTime{0, kLongestRunS};
constexpr Range kDuration{0.001, kLongestRunS};
constexpr Range kLength{-1000, 1000};
constexpr Range kSpeed{-5000, 5000};
constexpr Range kAny{-1e9, 1e9};
constexpr int kMostStrokes = 1000;

void readStrokes(JsonMembers& members, std::vector<MotionStep>& steps) {
  haptics::StrokeSeries series;
  members.integer("count", series.count, {1, kMostStrokes});
  members.number("length_mm", series.length_mm, kLength);
  members.number("settle_s", series.settle_s, kTime);
  members.number("forward_s", series.forward_s, kDuration);
  members.number("hold_s", series.hold_s, kTime);
  members.number("back_s", series.back_s, kDuration);
  members.number("pause_s", series.pause_s, kTime);
  const auto all = spelledOut(series);
  steps.insert(steps.end(), all.begin(), all.end());
}

void readStep(const Json& json, const std::string& place, std::vector<MotionStep>& steps, Problem& error) {
  JsonMembers members(json, place, error);
  members.require("do");
  const auto word =
      members.word("do", {"rest", "stroke", "go_to", "push", "swing", "press", "release", "let_go", "hold", "strokes"});
  constexpr Kind kKinds[] = {Kind::kRest,  Kind::kStroke,  Kind::kGoTo,  Kind::kPush, Kind::kSwing,
                             Kind::kPress, Kind::kRelease, Kind::kLetGo, Kind::kHold};
  if (word == std::size(kKinds)) {
    readStrokes(members, steps);
  } else if (word) {
    MotionStep step{.kind = kKinds[*word]};
    const auto needed = [&](std::string_view key, double& target, Range range) {
      members.require(key);
      members.number(key, target, range);
    };
    if (*word < 5) needed("duration_s", step.duration_s, kDuration);
    if (step.kind == Kind::kStroke) needed("length_mm", step.length_mm, kLength);
    if (step.kind == Kind::kGoTo) needed("position_mm", step.position_mm, kLength);
    if (step.kind == Kind::kPush) needed("speed_mm_s", step.speed_mm_s, kSpeed);
    if (step.kind == Kind::kSwing) {
      needed("amplitude_mm", step.amplitude_mm, {0, 100});
      needed("frequency_hz", step.frequency_hz, {0, 100});
    }
    steps.push_back(step);
  }
  members.finish();
}

void readHand(const Json& json, const std::string& place, Scenario& scenario, Problem& error) {
  JsonMembers members(json, place, error);
  if (const auto preset = members.word("preset", {"none", "pinch", "arm", "five-parameter"}))
    scenario.device.hand = haptics::handPresets()[*preset];
  auto& hand = scenario.device.hand;
  members.number("mass_kg", hand.mass_kg, {0, 100});
  members.number("damping_n_s_m", hand.damping_n_s_m, {0, 1000});
  members.number("stiffness_n_m", hand.stiffness_n_m, {0, 1e5});
  members.number("tremor_mm", scenario.tremor_mm, {0, 10});
  members.number("tremor_hz", scenario.tremor_hz, {0, 100});
  members.finish();
}

void readDevice(const Json& json, const std::string& place, haptics::VirtualDeviceSettings& device, Problem& error) {
  JsonMembers members(json, place, error);
  members.number("mass_kg", device.mechanics.mass_kg, {0.001, 100});
  members.number("damping_n_s_m", device.mechanics.damping_n_s_m, {0, 1000});
  members.number("friction_n", device.mechanics.dry_friction_n, {0, 1000});
  members.number("count_mm", device.count_mm, {0, 10});
  members.number("delay_s", device.delay_s, {0, 0.1});
  members.number("max_force_n", device.max_force_n, {0.001, 100});
  members.number("continuous_force_n", device.continuous_force_n, {0.001, 100});
  members.number("dropped_share", device.dropped_share, {0, 1});
  members.number("stalls_per_s", device.stalls_per_s, {0, 1000});
  members.integer("shortest_stall_ms", device.shortest_stall_ms, {1, 1000});
  members.integer("longest_stall_ms", device.longest_stall_ms, {1, 1000});
  members.number("quiet_after_s", device.quiet_after_s, {0.001, 1000});
  members.finish();
}

void readEnable(const Json& json, const std::string& place, haptics::EnableSettings& enable, Problem& error) {
  JsonMembers members(json, place, error);
  if (const auto kind = members.word("by", {"button", "latch"}))
    enable.kind = *kind == 0 ? haptics::EnableKind::kButton : haptics::EnableKind::kLatch;
  members.number("press_debounce_s", enable.press_debounce_s, {0, 1});
  members.number("release_zone_mm", enable.release_zone_mm, kLength);
  members.number("start_zone_mm", enable.start_zone_mm, {0, 1000});
  members.finish();
}

void readEvent(const Json& json, const std::string& place, Scenario& scenario, Problem& error) {
  JsonMembers members(json, place, error);
  ScenarioEvent event;
  members.require("at_s");
  members.number("at_s", event.at_s, kTime);
  members.numbers("conditions", event.conditions, kAny);
  members.text("model", event.model);
  members.number("fade_s", event.fade_s, {0, 60});
  if (const auto source = members.word("source", {"off", "free", "stimulus", "insertion"}))
    event.source = static_cast<haptics::ForceSource>(*source);
  members.number("stimulus_n", event.stimulus_n, {0, 3});
  members.flag("armed", event.armed);
  members.flag("program_alive", event.program_alive);
  members.flag("stop", event.stop);
  members.flag("placement", event.placement);

  haptics::FaultEvent fault{.start_s = event.at_s};
  const auto word = members.word("fault", {"unplugged", "stalled", "stuck_value", "not_a_number", "warm_motors"});
  members.number("duration_s", fault.duration_s, kDuration);
  if (word) {
    fault.fault = static_cast<haptics::InjectedFault>(*word);
    scenario.device.faults.push_back(fault);
  }
  members.finish();
  scenario.events.push_back(std::move(event));
}

void readLimits(const Json& json, const std::string& place, Scenario& scenario, Problem& error) {
  JsonMembers members(json, place, error);
  members.flag("expert", scenario.expert_limits);
  members.flag("guard_velocity", scenario.guard_velocity);
  members.finish();
}

Scenario readWhole(const Json& json, Problem& error) {
  Scenario scenario;
  JsonMembers members(json, "", error);
  for (const char* key : {"format", "version", "motion"}) members.require(key);
  if (!error && json.at("format") != "tactus-scenario") members.refuse("format", "tactus-scenario");
  if (!error && json.at("version") != 1) members.refuse("version", "1");
  members.text("name", scenario.name);
  members.integer("seed", scenario.device.seed);
  members.numbers("conditions", scenario.conditions, kAny);
  members.number("start_depth_mm", scenario.start_depth_mm, {0, 1000});
  if (const Json* const part = members.child("hand")) readHand(*part, members.placeOf("hand"), scenario, error);
  if (const Json* const part = members.child("device"))
    readDevice(*part, members.placeOf("device"), scenario.device, error);
  if (const Json* const part = members.child("enable"))
    readEnable(*part, members.placeOf("enable"), scenario.enable, error);
  if (const Json* const part = members.child("limits")) readLimits(*part, members.placeOf("limits"), scenario, error);
  for (const auto& [step, place] : members.elements("motion")) readStep(*step, place, scenario.motion, error);
  for (const auto& [event, place] : members.elements("events")) readEvent(*event, place, scenario, error);
  scenario.duration_s = durationS(scenario.motion);
  members.number("duration_s", scenario.duration_s, kDuration);
  members.finish();
  return scenario;
}

}  // namespace

base::Result<Scenario> parseScenario(std::string_view text) {
  if (!base::isUtf8(text)) return base::fail(ErrorCode::kSyntax, "", "text that is not UTF-8", "UTF-8");
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& failed) {
    const auto before = text.substr(0, std::min(text.size(), failed.byte == 0 ? 0 : failed.byte - 1));
    return base::fail(ErrorCode::kSyntax, "line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n')),
                      "text that is not JSON", "a scenario as in docs/scenario.md");
  }
  Problem error;
  Scenario scenario = readWhole(json, error);
  if (error) return tl::unexpected(*error);
  if (!(scenario.duration_s > 0 && scenario.duration_s <= kLongestRunS)) {
    return base::fail(ErrorCode::kLimit, "/motion", base::formatNumber(scenario.duration_s) + " s in all",
                      "more than 0 s and at most " + base::formatNumber(kLongestRunS) + " s");
  }
  if (auto checked = haptics::check(scenario.device); !checked) return tl::unexpected(checked.error());
  std::stable_sort(scenario.events.begin(), scenario.events.end(),
                   [](const auto& one, const auto& other) { return one.at_s < other.at_s; });
  return scenario;
}

base::Result<Scenario> readScenario(const std::string& path) {
  const auto text = base::readFile(path, kMostScenarioBytes);
  if (!text) return tl::unexpected(text.error());
  auto scenario = parseScenario(*text);
  if (!scenario) return base::inFile(scenario.error(), path);
  return scenario;
}

haptics::HandPlan handPlan(const Scenario& scenario) {
  auto plan = planOf(scenario.motion);
  if (scenario.tremor_mm == 0) return plan;
  return haptics::both(std::move(plan), haptics::swing(scenario.tremor_mm, scenario.tremor_hz));
}

}  // namespace tactus::simulation
