#include "core/render/tube_checks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "core/base/random.h"
#include "core/base/text.h"
#include "core/fuzzy/scene.h"
#include "core/render/insertion.h"
#include "core/render/tube_scene.h"

namespace tactus::render {
namespace {

/// The hand of a script: each movement begins where the one before has ended.
class Script {
 public:
  Script(std::string name, std::vector<double> conditions) : conditions_(std::move(conditions)) {
    trace_.name = std::move(name);
  }

  Script& hold(bool held) {
    held_ = held;
    return *this;
  }
  Script& conditions(std::vector<double> values) {
    conditions_ = std::move(values);
    return *this;
  }
  /// In `seconds` by `way_mm`, begun and ended at rest (minimum jerk).
  Script& move(double way_mm, double seconds, double dt_s = 0.001) {
    const double from_mm = position_mm_;
    const auto steps = static_cast<int>(std::lround(seconds / dt_s));
    for (int i = 1; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      add(from_mm + way_mm * (t * t * t * (10 + t * (6 * t - 15))), dt_s);
    }
    return *this;
  }
  Script& rest(double seconds, double dt_s = 0.001) { return move(0, seconds, dt_s); }
  /// One step.
  Script& add(double position_mm, double dt_s) {
    // Few digits: a reader need not be able to read seventeen.
    position_mm_ = std::round(position_mm * 1e4) / 1e4;
    trace_.steps.push_back({position_mm_, held_, dt_s, conditions_});
    return *this;
  }
  double positionMm() const { return position_mm_; }
  TubeTrace done() { return std::move(trace_); }

 private:
  TubeTrace trace_;
  std::vector<double> conditions_;
  double position_mm_ = 0;
  bool held_ = false;
};

/// The conditions at `share` of their universes, the first one at `first` of it.
std::vector<double> conditionsAt(const fuzzy::ForceModel& model, const TubeInputs& inputs, double first, double share) {
  std::vector<double> out;
  for (const std::size_t i : inputs.conditions) {
    const fuzzy::Variable& input = model.inputs[i];
    const double at = input.min + (input.max - input.min) * (out.empty() ? first : share);
    out.push_back(std::round(at * 1e4) / 1e4);
  }
  return out;
}

TubeTrace randomHand(const fuzzy::ForceModel& model, const TubeInputs& inputs, int number) {
  base::Random random(static_cast<std::uint64_t>(100 + number));
  const auto some = [&] { return conditionsAt(model, inputs, random.uniform(), random.uniform()); };
  Script script("random_hand_" + std::to_string(number), some());
  script.hold(true).add(0, 0.001);
  double speed_mm_s = 0;
  for (int i = 0; i < 700; ++i) {
    if (random.below(60) == 0) speed_mm_s = random.uniform(-80, 250);
    if (random.below(120) == 0) script.hold(random.below(4) != 0);
    if (random.below(150) == 0) script.conditions(some());
    const double dt_s = random.below(20) == 0 ? 0.004 : random.below(20) == 0 ? 0.00025 : 0.001;
    script.add(script.positionMm() + speed_mm_s * dt_s + random.uniform(-0.05, 0.05), dt_s);
  }
  return script.done();
}

/// Past the place of an event, back, on in the same stroke; back again, and past it in the next stroke.
TubeTrace puncture(const std::string& name, double place_mm, double stiffness_n_mm,
                   const std::vector<double>& conditions) {
  // The hand leads the tube by as much as the spring takes at the cap, either way; a soft spring would need a long way.
  const double lead_mm = std::min(kTubeCapN / stiffness_n_mm, 60.0);
  const double back_mm = 2 * lead_mm + 3;
  const double in_mm = std::max(place_mm, 0.0) + lead_mm + 1.5;
  const double in_s = std::max(0.1, in_mm / 150);
  return Script(name, conditions)
      .hold(true)
      .move(in_mm, in_s, in_s > 0.5 ? 0.002 : 0.001)
      .move(-back_mm, back_mm / 150)
      .move(back_mm, back_mm / 150)
      .move(-back_mm, back_mm / 150)
      .hold(false)
      .rest(0.04)
      .hold(true)
      .move(back_mm, back_mm / 150)
      .done();
}

}  // namespace

base::Result<TubeInputs> tubeInputs(const fuzzy::ForceModel& model) {
  const auto depth = fuzzy::wayOf(model.inputs);
  if (!depth) {
    return base::fail(base::ErrorCode::kValue, "inputs", "none that is the way of the tip",
                      "an input of the role 'way', or called 'depth'");
  }
  TubeInputs out{*depth, fuzzy::rateOf(model.inputs), {}};
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (i != out.depth && i != out.speed) out.conditions.push_back(i);
  }
  const fuzzy::Variable* const speed = out.speed ? &model.inputs[*out.speed] : nullptr;
  if (auto units = checkTubeUnits(&model.inputs[*depth], speed, model.output); !units)
    return tl::unexpected(std::move(units).error());
  return out;
}

std::vector<TubeTrace> tubeTraces(const fuzzy::ForceModel& model, const TubeInputs& inputs) {
  const fuzzy::Variable& depth = model.inputs[inputs.depth];
  const fuzzy::RendererParameters friction = model.renderer.value_or(fuzzy::RendererParameters());
  const double end_mm = depth.max - friction.depth_offset_mm;
  const auto dry = conditionsAt(model, inputs, 0.9, 0.5);
  const auto wet = conditionsAt(model, inputs, 0.2, 0.75);
  std::vector<TubeTrace> out;
  out.push_back(Script("strokes_with_stops", dry)
                    .rest(0.01)
                    .hold(true)
                    .move(45, 0.35)
                    .rest(0.12)
                    .move(30, 0.3)
                    .hold(false)
                    .move(-60, 0.2, 0.002)
                    .hold(true)
                    .move(60, 0.4)
                    .hold(false)
                    .rest(0.05)
                    .done());
  out.push_back(Script("slow_push_and_slow_stop", wet).hold(true).move(4, 0.8, 0.002).rest(0.2, 0.002).done());
  out.push_back(
      Script("withdrawal_to_the_entry", dry).hold(true).move(40, 0.4).move(-70, 0.5).rest(0.05).move(8, 0.1).done());
  Script end("to_the_end_of_the_depth", wet);
  end.hold(true).add(0, 0.001);
  // A hand may go as far as it likes within a step.
  for (int i = 0; i < 40; ++i) end.add(end.positionMm() + end_mm / 36, 0.02);
  out.push_back(end.rest(0.1, 0.005).move(-30, 0.2, 0.002).done());
  Script tremor("a_trembling_hand", dry);
  tremor.hold(true).move(6, 0.1);
  for (int i = 0; i < 300; ++i)
    tremor.add(6 + 0.8 * std::sin(2 * std::numbers::pi * 9 * i * 0.001) + (i % 7 == 0 ? 0.055 : 0), 0.001);
  out.push_back(tremor.done());
  out.push_back(Script("other_conditions_in_the_hand", dry)
                    .hold(true)
                    .move(30, 0.25)
                    .conditions(wet)
                    .move(15, 0.12)
                    .conditions(dry)
                    .rest(0.02)
                    .conditions(wet)
                    .rest(0.1)
                    .move(20, 0.15)
                    .hold(false)
                    .conditions(dry)
                    .rest(0.04)
                    .hold(true)
                    .move(10, 0.1)
                    .done());
  Script wrong("impossible_steps", wet);
  wrong.hold(true).move(20, 0.2).add(wrong.positionMm(), 0).move(5, 0.05).hold(false).rest(0.01).hold(true);
  wrong.move(20, 0.15).add(2e6, 0.001).move(-2e6 + 40, 0.003).hold(false).rest(0.005).hold(true).move(10, 0.1);
  wrong.add(wrong.positionMm(), 1.5).hold(false).rest(0.01).hold(true).move(10, 0.1).add(wrong.positionMm() + 40, 1);
  out.push_back(wrong.rest(0.02).done());
  out.push_back(Script("a_press_in_motion", dry).move(120, 0.3).hold(true).move(300, 0.25).rest(0.1).done());
  for (int number = 1; number <= 2; ++number) out.push_back(randomHand(model, inputs, number));
  for (const fuzzy::TubeEvent& event : model.events) {
    const double place_mm = fuzzy::endOfCore(depth, *fuzzy::findTerm(depth.terms, event.term));
    out.push_back(puncture("puncture_" + std::to_string(&event - model.events.data() + 1),
                           place_mm - friction.depth_offset_mm, friction.stiffness_n_mm, dry));
  }
  return out;
}

struct TubeRun::State {
  TubeSettings settings;
  TubeInputs inputs;
  fuzzy::CompiledModel compiled;
  std::size_t count = 0;  ///< of the model's inputs
  Insertion insertion;
  std::optional<TubeScene> scene;
  std::vector<double> conditions;
  double fade_s = 0;  ///< of the first scene: there is nothing before it
};

TubeRun::TubeRun(const fuzzy::ForceModel& model, TubeInputs inputs, fuzzy::CompiledModel compiled)
    : state_(std::make_unique<State>()) {
  state_->settings.renderer = model.renderer.value_or(fuzzy::RendererParameters());
  state_->settings.depth_end_mm = model.inputs[inputs.depth].max;
  state_->settings.events =
      TubeEvents(model.inputs[inputs.depth], model.events, state_->settings.renderer.depth_offset_mm);
  // Places among the free inputs.
  state_->settings.depth = inputs.speed && *inputs.speed < inputs.depth ? 1 : 0;
  if (inputs.speed) state_->settings.speed = inputs.depth < *inputs.speed ? 1 : 0;
  state_->inputs = std::move(inputs);
  state_->compiled = std::move(compiled);
  state_->count = model.inputs.size();
}

TubeRun::~TubeRun() = default;
TubeRun::TubeRun(TubeRun&&) noexcept = default;
TubeRun& TubeRun::operator=(TubeRun&&) noexcept = default;

base::Result<TubeFeel> TubeRun::step(const TubeStep& step) {
  State& own = *state_;
  if (!own.scene || step.conditions != own.conditions) {
    std::vector<std::optional<double>> fixed(own.count);
    for (std::size_t c = 0; c < own.inputs.conditions.size(); ++c) fixed[own.inputs.conditions[c]] = step.conditions[c];
    TACTUS_TRY(auto scene, fuzzy::Scene::specialize(own.compiled, fixed, fuzzy::SceneUse::kPoints));
    if (own.scene) own.fade_s = kTraceFadeS;
    own.scene.emplace(std::move(scene), own.settings);
    own.conditions = step.conditions;
  }
  own.insertion.tick({.active = true,
                      .enabled = step.held,
                      .position_mm = step.position_mm,
                      .force_cap_n = kTubeCapN,
                      .scene = &*own.scene,
                      .fade_s = own.fade_s,
                      .dt_s = step.dt_s});
  const RendererState& state = own.insertion.state();
  const int phase = std::min(static_cast<int>(state.phase), static_cast<int>(Phase::kSlidingIn));
  return TubeFeel{state.force_n, state.depth_mm, phase, state.stroke.number};
}

}  // namespace tactus::render
