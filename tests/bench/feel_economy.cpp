#include "tests/bench/feel_economy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "app/simulation/scenario_run.h"
#include "core/base/check.h"
#include "core/fuzzy/compiled_model.h"
#include "core/haptics/simulated/virtual_device.h"

#include "tests/bench/cases.h"
#include "tests/bench/feel_loop.h"
#include "tests/bench/interleaved.h"

namespace tactus::bench {
namespace {

using haptics::Conditions;
using ScenePointer = std::shared_ptr<const haptics::ServoScene>;

/// A tick of the placement: what the device said, what the renderer was told, and under which conditions.
struct PlacedTick {
  haptics::DeviceState device;
  double position_mm = 0;
  bool enabled = false;
  std::size_t conditions = 0;  ///< place in Placement::orders
  double force_n = 0;          ///< of the servo in the scenario
};

/// The placement of the programs' own scenario, run once on a model.
struct Placement {
  fuzzy::CompiledModel compiled;
  std::vector<Conditions> conditions;
  std::vector<haptics::ServoOrders> orders;  ///< one per set of conditions
  haptics::DeviceInfo device;
  std::vector<PlacedTick> ticks;
  render::SceneCounters counters;
};

ScenePointer sceneOf(const fuzzy::ForceModel& model, const Conditions& conditions, double fade_s) {
  haptics::SceneSettings settings;
  settings.fade_s = fade_s;
  settings.largest_cost_s = std::numeric_limits<double>::infinity();
  auto scene = haptics::ServoScene::make(model, conditions, settings);
  TACTUS_CHECK(scene.has_value());
  return std::move(*scene);
}

Placement placementOn(const fuzzy::ForceModel& model) {
  const auto scenario = simulation::parseScenario(simulation::placementScenarioJson());
  TACTUS_CHECK(scenario.has_value());
  const auto compiled = fuzzy::compile(model);
  TACTUS_CHECK(compiled.has_value());
  const auto device = haptics::VirtualDevice::make(scenario->device);
  TACTUS_CHECK(device.has_value());
  Placement out{*compiled, {}, {}, (*device)->info(), {}, {}};
  const auto summary = simulation::runScenario(*scenario, model, {}, [&](const simulation::TraceTick& traced) {
    if (out.conditions.empty() || out.conditions.back() != *traced.conditions) {
      out.conditions.push_back(*traced.conditions);
    }
    const haptics::Sample& sample = traced.sample;
    PlacedTick tick;
    tick.device.number = sample.tick;
    tick.device.time_ns = sample.time_ns;
    tick.device.position_mm = sample.position_mm * haptics::AxisMapping().inwards();
    tick.device.buttons = sample.buttons;
    tick.device.written_ns = sample.time_ns;
    tick.position_mm = sample.position_mm;
    tick.enabled = sample.enabled;
    tick.conditions = out.conditions.size() - 1;
    tick.force_n = sample.force_n;
    out.ticks.push_back(tick);
  });
  TACTUS_CHECK(summary.has_value());
  out.counters = summary->scene;
  TACTUS_CHECK(out.conditions.size() == scenario->events.size() + 1);
  for (std::size_t c = 0; c < out.conditions.size(); ++c) {
    haptics::ServoOrders orders;
    orders.source = haptics::ForceSource::kInsertion;
    orders.armed = true;
    orders.placement = 1;
    orders.enable = scenario->enable;
    orders.limits = haptics::LimitSettings::forDevice(out.device);
    orders.scene = sceneOf(model, out.conditions[c], c == 0 ? 0 : scenario->events[c - 1].fade_s);
    out.orders.push_back(std::move(orders));
  }
  return out;
}

/// The whole tick of the servo on the recorded device; `each` gets every force.
template <typename Each>
render::SceneCounters replay(const Placement& placement, Each each) {
  haptics::ServoCore core(placement.device);
  for (const PlacedTick& tick : placement.ticks)
    each(core.tick(told(tick.device, placement.orders[tick.conditions])).force_n);
  return core.counters();
}

/// How the renderer gets its force.
struct Way {
  const char* name;
  bool only_when_needed;
  bool specialized;
};
constexpr Way kWays[] = {{"asked when needed, specialized", true, true},
                         {"asked when needed, whole model", true, false},
                         {"asked at each tick, specialized", false, true},
                         {"asked at each tick, whole model", false, false}};

/// The renderer on the recorded positions, without hand-over; `each` gets every resistance.
template <typename Each>
void replayRenderer(const Placement& placement, const Way& way, Each each) {
  render::RendererState state;
  render::RendererSettings settings;
  std::array<double, 4> point{};  // lubrication, neck flexion, depth, speed: the inputs of the model
  for (const PlacedTick& tick : placement.ticks) {
    const haptics::ServoScene& scene = *placement.orders[tick.conditions].scene;
    const Conditions& conditions = placement.conditions[tick.conditions];
    settings.friction = scene.renderer();
    settings.depth_end_mm = scene.depthEndMm();
    render::RendererInput input{tick.position_mm, tick.enabled, tick.conditions + 1, {}};
    auto where = render::forceNeeded(state, input, settings);
    if (!where && !way.only_when_needed) {
      const bool in = state.phase == render::Phase::kSlidingIn;
      where = render::ForcePoint{state.depth_mm + settings.friction.depth_offset_mm,
                                 in ? std::max(0.0, state.slip_speed_mm_s.value) : 0};
    }
    if (where && way.specialized) {
      input.force = scene.force(*where);
    } else if (where) {
      point = {conditions.at("lubrication"), conditions.at("neck_flexion"), where->depth_mm, where->speed_mm_s};
      const fuzzy::Evaluation force = placement.compiled.evaluate(point);
      input.force = render::ModelForce{force.force_n, force.fired};
    }
    state = render::step(state, input, settings, kFeelTickS);
    each(state.force_n);
  }
}

/// A whole placement as one evaluation.
template <typename Run>
Job placementJob(Run run) {
  return {"", 1, [run](std::size_t /*first*/, std::span<double> out) {
            double sum = 0;
            run([&sum](double force_n) { sum += force_n; });
            out.front() = sum;
          }};
}

template <typename Run>
std::vector<double> forcesOf(Run run) {
  std::vector<double> forces_n;
  run([&forces_n](double force_n) { forces_n.push_back(force_n); });
  return forces_n;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  TACTUS_CHECK(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

void measureOn(FeelPart& part, const std::string& who, const Placement& placement, int rounds) {
  std::vector<Job> jobs;
  for (const Way& way : kWays)
    jobs.push_back(placementJob([&placement, &way](auto each) { replayRenderer(placement, way, each); }));
  jobs.push_back(placementJob([&placement](auto each) { replay(placement, each); }));
  const auto timed = timeInterleaved(jobs, {.rounds = rounds});
  const auto ticks = static_cast<double>(placement.ticks.size());
  const auto median_ns = [&](std::size_t job) { return timed.timings[job].median_ns / ticks; };
  const auto least_ns = [&](std::size_t job) { return timed.timings[job].min_ns / ticks; };

  const auto wanted = forcesOf([&](auto each) { replayRenderer(placement, kWays[0], each); });
  for (std::size_t w = 0; w < std::size(kWays); ++w) {
    const std::string name = who + ": renderer, " + kWays[w].name;
    part.add(name, "median of a tick", "ns", median_ns(w));
    part.add(name, "least", "ns", least_ns(w));
    part.add(name, "times the economy", "1", least_ns(w) / least_ns(0));
    part.add(name, "largest difference of the force", "N",
             largestDifference(wanted, forcesOf([&](auto each) { replayRenderer(placement, kWays[w], each); })));
  }
  const std::size_t whole = std::size(kWays);
  const double without_ns = least_ns(whole) + least_ns(whole - 1) - least_ns(0);
  std::vector<double> served_n, recorded_n;
  const auto counters = replay(placement, [&served_n](double force_n) { served_n.push_back(force_n); });
  TACTUS_CHECK(counters == placement.counters);
  for (const PlacedTick& tick : placement.ticks) recorded_n.push_back(tick.force_n);
  const std::string name = who + ": core tick, with the economy";
  part.add(name, "median of a tick", "ns", median_ns(whole));
  part.add(name, "least", "ns", least_ns(whole));
  part.add(name, "times the economy", "1", 1);
  part.add(name, "largest difference of the force", "N", largestDifference(served_n, recorded_n));
  part.add(name, "ticks", "1", static_cast<double>(counters.ticks));
  part.add(name, "asked", "1", static_cast<double>(counters.asked));
  part.add(name, "released", "1", static_cast<double>(counters.released));
  part.add(name, "unchanged", "1", static_cast<double>(counters.unchanged));
  const std::string without = who + ": core tick, without (computed)";
  part.add(without, "least", "ns", without_ns);
  part.add(without, "times the economy", "1", without_ns / least_ns(whole));
}

}  // namespace

FeelPart measureEconomy(int rounds) {
  FeelPart part{
      "economy", "A whole placement (scenario placement.json, simulated): what the scene economy saves", {}, {}};
  for (const int count : {1, 4, 32}) {
    measureOn(part, std::to_string(count) + (count == 1 ? " expert" : " experts"), placementOn(syntheticExperts(count)),
              std::max(3, rounds / 4));
  }
  part.notes = {
      "Renderer: on the positions of the placement, conditions change at once; differences are from the first row "
      "of the model. Core tick: the placement once more, differences are from the scenario's own run",
      "Least, and the ratios from it: the fastest replay. Without (computed): the core tick, and what the renderer "
      "takes "
      "longer when it asks the whole model at each tick"};
  return part;
}

}  // namespace tactus::bench
