#include "app/simulation/scenario.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_members.h"
#include "core/base/text.h"

namespace tactus::simulation {
namespace {

using base::ErrorCode;
using base::JsonMembers;
using base::JsonValue;
using base::NumberRange;
using base::required;
using Kind = MotionStep::Kind;
using Problem = std::optional<base::Error>;

constexpr NumberRange kTime{0, kLongestRunS};
constexpr NumberRange kDuration{0.001, kLongestRunS};
constexpr NumberRange kLength{-1000, 1000};
constexpr NumberRange kSpeed{-5000, 5000};
constexpr NumberRange kAny{-1e9, 1e9};
constexpr int kMostStrokes = 1000;
/// More steps than milliseconds in the longest run make no sense.
constexpr std::size_t kMostSteps = 100'000;

constexpr std::string_view kStepWords[] = {"rest",  "stroke",  "go_to",  "push", "swing",
                                           "press", "release", "let_go", "hold", "strokes"};
constexpr Kind kStepKinds[] = {Kind::kRest,  Kind::kStroke,  Kind::kGoTo,  Kind::kPush, Kind::kSwing,
                               Kind::kPress, Kind::kRelease, Kind::kLetGo, Kind::kHold};
constexpr std::string_view kEnableWords[] = {"button", "latch"};
constexpr haptics::EnableKind kEnableKinds[] = {haptics::EnableKind::kButton, haptics::EnableKind::kLatch};

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

void readStep(const JsonValue& value, std::vector<MotionStep>& steps, Problem& error) {
  JsonMembers members(value, error);
  const auto word = members.word(required("do"), kStepWords);
  if (word == std::size(kStepKinds)) {
    readStrokes(members, steps);
  } else if (word) {
    MotionStep step{.kind = kStepKinds[*word]};
    if (*word < 5) members.number(required("duration_s"), step.duration_s, kDuration);
    if (step.kind == Kind::kStroke) members.number(required("length_mm"), step.length_mm, kLength);
    if (step.kind == Kind::kGoTo) members.number(required("position_mm"), step.position_mm, kLength);
    if (step.kind == Kind::kPush) members.number(required("speed_mm_s"), step.speed_mm_s, kSpeed);
    if (step.kind == Kind::kSwing) {
      members.number(required("amplitude_mm"), step.amplitude_mm, {0, 100});
      members.number(required("frequency_hz"), step.frequency_hz, {0, 100});
    }
    steps.push_back(step);
  }
  members.refuseOthers();
  if (steps.size() > kMostSteps) members.refuse("do", "at most " + std::to_string(kMostSteps) + " steps in all");
}

void readHand(const JsonValue& value, Scenario& scenario, Problem& error) {
  JsonMembers members(value, error);
  std::vector<std::string_view> names;
  for (const auto& hand : haptics::handPresets()) names.push_back(hand.name);
  if (const auto preset = members.word("preset", names)) scenario.device.hand = haptics::handPresets()[*preset];
  auto& hand = scenario.device.hand;
  members.number("mass_kg", hand.mass_kg, {0, 100});
  members.number("damping_n_s_m", hand.damping_n_s_m, {0, 1000});
  members.number("stiffness_n_m", hand.stiffness_n_m, {0, 1e5});
  members.number("tremor_mm", scenario.tremor_mm, {0, 10});
  members.number("tremor_hz", scenario.tremor_hz, {0, 100});
  members.refuseOthers();
}

void readDevice(const JsonValue& value, haptics::VirtualDeviceSettings& device, Problem& error) {
  JsonMembers members(value, error);
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
  members.refuseOthers();
}

void readEnable(const JsonValue& value, haptics::EnableSettings& enable, Problem& error) {
  JsonMembers members(value, error);
  if (const auto kind = members.word("by", kEnableWords)) enable.kind = kEnableKinds[*kind];
  members.number("press_debounce_s", enable.press_debounce_s, {0.01, 0.1});
  members.number("release_zone_mm", enable.release_zone_mm, kLength);
  members.number("start_zone_mm", enable.start_zone_mm, {0.1, 1000});
  members.refuseOthers();
}

void readLimits(const JsonValue& value, Scenario& scenario, Problem& error) {
  JsonMembers members(value, error);
  members.flag("expert", scenario.expert_limits);
  members.flag("guard_velocity", scenario.guard_velocity);
  members.refuseOthers();
}

template <class Enum>
std::vector<std::string_view> namesOf(std::initializer_list<Enum> all) {
  std::vector<std::string_view> names;
  for (const Enum one : all) names.push_back(name(one));
  return names;
}

void readFault(JsonMembers& members, const ScenarioEvent& event, Scenario& scenario) {
  using enum haptics::InjectedFault;
  haptics::FaultEvent fault{.start_s = event.at_s};
  const auto word = members.word("fault", namesOf({kUnplugged, kStalled, kStuckValue, kNotANumber, kWarmMotors}));
  members.number("duration_s", fault.duration_s, kDuration);
  if (!word) return;
  fault.fault = static_cast<haptics::InjectedFault>(*word);
  scenario.device.faults.push_back(fault);
}

void readEvent(const JsonValue& value, Scenario& scenario, Problem& error) {
  using enum haptics::ForceSource;
  JsonMembers members(value, error);
  ScenarioEvent event;
  event.place = value.pointer();
  members.number(required("at_s"), event.at_s, kTime);
  members.numbers("conditions", event.conditions, kAny);
  members.text("model", event.model);
  members.number("fade_s", event.fade_s, {0, 60});
  if (const auto source = members.word("source", namesOf({kOff, kFree, kStimulus, kInsertion})))
    event.source = static_cast<haptics::ForceSource>(*source);
  members.number("stimulus_n", event.stimulus_n, {0, 3});
  members.flag("armed", event.armed);
  members.flag("program_alive", event.program_alive);
  members.flag("stop", event.stop);
  members.flag("placement", event.placement);
  readFault(members, event, scenario);
  members.refuseOthers();

  // What would have no effect is a typing error.
  if (members.has("fade_s") && !members.has("conditions") && !members.has("model"))
    members.refuse("fade_s", "conditions or a model that fade");
  if (members.has("duration_s") && !members.has("fault")) members.refuse("duration_s", "a fault that lasts");
  bool any = false;
  for (const char* key :
       {"conditions", "model", "source", "stimulus_n", "armed", "program_alive", "stop", "placement", "fault"})
    any = any || members.has(key);
  if (!any) members.refuse("at_s", "something that happens at this time");
  scenario.events.push_back(std::move(event));
}

Scenario readWhole(const JsonValue& root, Problem& error) {
  Scenario scenario;
  JsonMembers members(root, error);
  members.format("tactus-scenario");
  members.version(required("version"));
  members.text("name", scenario.name);
  members.integer("seed", scenario.device.seed);
  members.numbers("conditions", scenario.conditions, kAny);
  members.number("start_depth_mm", scenario.start_depth_mm, {0, 1000});
  if (const auto part = members.child("hand")) readHand(*part, scenario, error);
  if (const auto part = members.child("device")) readDevice(*part, scenario.device, error);
  if (const auto part = members.child("enable")) readEnable(*part, scenario.enable, error);
  if (const auto part = members.child("limits")) readLimits(*part, scenario, error);
  for (const JsonValue& step : members.elements(required("motion")))
    if (!error) readStep(step, scenario.motion, error);
  for (const JsonValue& event : members.elements("events"))
    if (!error) readEvent(event, scenario, error);
  scenario.duration_s = durationS(scenario.motion);
  members.number("duration_s", scenario.duration_s, kDuration);
  members.refuseOthers();
  return scenario;
}

base::Result<void> checkTimes(const Scenario& scenario) {
  if (!(scenario.duration_s > 0 && scenario.duration_s <= kLongestRunS)) {
    return base::fail(ErrorCode::kLimit, "/motion", base::formatNumber(scenario.duration_s) + " s in all",
                      "more than 0 s and at most " + base::formatNumber(kLongestRunS) + " s");
  }
  for (const auto& event : scenario.events) {
    if (event.at_s < scenario.duration_s) continue;
    return base::fail(ErrorCode::kValue, event.place + "/at_s", base::formatNumber(event.at_s) + " s",
                      "a time before the end at " + base::formatNumber(scenario.duration_s) + " s");
  }
  return {};
}

}  // namespace

base::Result<Scenario> parseScenario(std::string_view text) {
  TACTUS_TRY(const auto document, base::JsonDocument::parse(text));
  Problem error;
  Scenario scenario = readWhole(document.root(), error);
  if (error) return tl::unexpected(*error);
  if (auto checked = checkTimes(scenario); !checked) return tl::unexpected(checked.error());
  if (auto checked = haptics::check(scenario.device); !checked) return tl::unexpected(checked.error());
  if (auto checked = haptics::check(scenario.enable); !checked) return tl::unexpected(checked.error());
  std::stable_sort(scenario.events.begin(), scenario.events.end(),
                   [](const auto& one, const auto& other) { return one.at_s < other.at_s; });
  return scenario;
}

base::Result<Scenario> readScenario(const std::string& path) {
  TACTUS_TRY(const auto text, base::readFile(path, kMostScenarioBytes));
  auto scenario = parseScenario(text);
  if (!scenario) return base::inFile(scenario.error(), path);
  return scenario;
}

haptics::HandPlan handPlan(const Scenario& scenario) {
  auto plan = planOf(scenario.motion);
  if (scenario.tremor_mm == 0) return plan;
  return haptics::both(std::move(plan), haptics::swing(scenario.tremor_mm, scenario.tremor_hz));
}

namespace {

using haptics::HandPlan;
using haptics::HandTarget;
using Kind = MotionStep::Kind;

/// A step with what came before it.
struct Leg {
  double start_s = 0;
  double start_mm = 0;
  bool holds = true;
  bool button = false;
  HandPlan way;  ///< from start_mm on; empty: the hand rests

  HandTarget at(double time_s) const {
    HandTarget wish = way ? way(time_s - start_s) : HandTarget{};
    wish.position_mm += start_mm;
    wish.holds = holds;
    wish.button = button;
    return wish;
  }
};

HandPlan wayOf(const MotionStep& step, double start_mm) {
  switch (step.kind) {
    case Kind::kStroke: return haptics::stroke(step.length_mm, step.duration_s);
    case Kind::kGoTo: return haptics::stroke(step.position_mm - start_mm, step.duration_s);
    case Kind::kPush: return haptics::push(step.speed_mm_s);
    case Kind::kSwing: return haptics::swing(step.amplitude_mm, step.frequency_hz);
    default: return {};
  }
}

}  // namespace

std::vector<MotionStep> spelledOut(const haptics::StrokeSeries& series) {
  std::vector<MotionStep> steps;
  for (int i = 0; i < series.count; ++i) {
    steps.push_back({.kind = Kind::kPress});
    steps.push_back({.kind = Kind::kRest, .duration_s = series.settle_s});
    steps.push_back({.kind = Kind::kStroke, .duration_s = series.forward_s, .length_mm = series.length_mm});
    steps.push_back({.kind = Kind::kRest, .duration_s = series.hold_s});
    steps.push_back({.kind = Kind::kRelease});
    steps.push_back({.kind = Kind::kStroke, .duration_s = series.back_s, .length_mm = -series.length_mm});
    steps.push_back({.kind = Kind::kRest, .duration_s = series.pause_s});
  }
  return steps;
}

double durationS(const std::vector<MotionStep>& steps) noexcept {
  double sum_s = 0;
  for (const auto& step : steps) sum_s += step.duration_s;
  return sum_s;
}

HandPlan planOf(const std::vector<MotionStep>& steps) {
  std::vector<Leg> legs(1);
  for (const auto& step : steps) {
    Leg& leg = legs.back();
    leg.way = wayOf(step, leg.start_mm);
    Leg next{.start_s = leg.start_s + step.duration_s,
             .start_mm = leg.at(leg.start_s + step.duration_s).position_mm,
             .holds = step.kind == Kind::kHold || (leg.holds && step.kind != Kind::kLetGo),
             .button = step.kind == Kind::kPress || (leg.button && step.kind != Kind::kRelease),
             .way = {}};
    legs.push_back(std::move(next));
  }
  return [legs = std::move(legs)](double time_s) {
    const auto after = std::upper_bound(legs.begin() + 1, legs.end(), time_s,
                                        [](double time, const Leg& leg) { return time < leg.start_s; });
    return std::prev(after)->at(time_s);
  };
}

}  // namespace tactus::simulation
