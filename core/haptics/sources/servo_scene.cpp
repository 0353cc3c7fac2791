#include "core/haptics/sources/servo_scene.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::haptics {
namespace {

using base::ErrorCode;
using fuzzy::ForceModel;
using fuzzy::Variable;

constexpr double kLongestFadeS = 60;
/// The costliest point is rarely the first, and the smallest of a few rounds is free of interruptions.
constexpr int kPointsTried = 32;
constexpr int kRounds = 5;
constexpr int kMultipliers[fuzzy::kMostInputs] = {1, 13, 7, 19, 3, 23, 11, 29};

const Variable* inputAt(const ForceModel& model, std::optional<std::size_t> index) {
  return index ? &model.inputs[*index] : nullptr;
}

/// One entry per input of the model: a value where it is fixed, nothing where the renderer moves it.
base::Result<std::vector<std::optional<double>>> fixedInputs(const ForceModel& model, const Conditions& conditions,
                                                             const Variable* depth, const Variable* speed) {
  std::vector<std::optional<double>> fixed(model.inputs.size());
  std::size_t used = 0;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const Variable& input = model.inputs[i];
    if (&input == depth || &input == speed) continue;
    const auto condition = conditions.find(input.id);
    if (condition == conditions.end()) {
      return base::fail(ErrorCode::kSchema, "condition " + base::quoted(input.id), "no value",
                        "a number from " + base::formatNumber(input.min) + " to " + base::formatNumber(input.max));
    }
    if (!std::isfinite(condition->second)) {
      return base::fail(ErrorCode::kValue, "condition " + base::quoted(input.id), base::formatNumber(condition->second),
                        "a finite number");
    }
    fixed[i] = condition->second;
    ++used;
  }
  if (used == conditions.size()) return fixed;
  std::vector<std::string> wanted;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (fixed[i]) wanted.push_back(model.inputs[i].id);
  }
  const auto unknown = std::find_if(conditions.begin(), conditions.end(), [&](const Conditions::value_type& condition) {
    return std::find(wanted.begin(), wanted.end(), condition.first) == wanted.end();
  });
  const bool is_moved =
      (depth != nullptr && depth->id == unknown->first) || (speed != nullptr && speed->id == unknown->first);
  return base::fail(
      ErrorCode::kReference, "condition " + base::quoted(unknown->first),
      is_moved ? "an input that the hand moves" : "no such input in the model",
      wanted.empty() ? "no conditions" : "conditions for " + base::joined(wanted, ", ") + " and nothing else");
}

std::string microseconds(double time_s) { return base::formatFixed(time_s * 1e6, 1) + " microseconds"; }

}  // namespace

double measuredCostS(const fuzzy::CompiledModel& compiled, double enough_s) {
  using Clock = std::chrono::steady_clock;
  constexpr double kFar = std::numeric_limits<double>::max();
  std::array<double, fuzzy::kMostInputs> point{};
  const auto inputs = std::span(point).first(compiled.inputCount());
  double cost_s = 0;
  for (int i = 0; i < kPointsTried && !(cost_s > enough_s); ++i) {
    for (std::size_t input = 0; input < inputs.size(); ++input) {
      // All values of each input; multipliers coprime to 32 mix them well.
      const double min = compiled.clampInput(input, -kFar);
      const double max = compiled.clampInput(input, kFar);
      const int step = i * kMultipliers[input] % kPointsTried;
      inputs[input] = min + (max - min) * step / (kPointsTried - 1);
    }
    double fastest_s = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kRounds; ++round) {
      const Clock::time_point start = Clock::now();
      [[maybe_unused]] const volatile double force_n = compiled.evaluate(inputs).force_n;
      fastest_s = std::min(fastest_s, std::chrono::duration<double>(Clock::now() - start).count());
    }
    cost_s = std::max(cost_s, fastest_s);
  }
  return cost_s;
}

base::Result<std::shared_ptr<const ServoScene>> ServoScene::make(const ForceModel& model, const Conditions& conditions,
                                                                 const SceneSettings& settings) {
  TACTUS_TRY(const auto compiled, fuzzy::compile(model));
  return make(model, compiled, conditions, settings);
}

base::Result<std::shared_ptr<const ServoScene>> ServoScene::make(const ForceModel& model,
                                                                 const fuzzy::CompiledModel& compiled,
                                                                 const Conditions& conditions,
                                                                 const SceneSettings& settings) {
  if (!(settings.fade_s >= 0 && settings.fade_s <= kLongestFadeS)) {
    return base::fail(ErrorCode::kValue, "fade of the hand-over", base::formatNumber(settings.fade_s) + " s",
                      "0 to " + base::formatNumber(kLongestFadeS) + " s");
  }
  const Variable* const depth = inputAt(model, fuzzy::wayOf(model.inputs));
  const Variable* const speed = inputAt(model, fuzzy::rateOf(model.inputs));
  if (auto units = render::checkTubeUnits(depth, speed, model.output); !units) return tl::unexpected(units.error());
  TACTUS_TRY(const auto fixed, fixedInputs(model, conditions, depth, speed));
  TACTUS_TRY(auto specialized, fuzzy::Scene::specialize(compiled, fixed, fuzzy::SceneUse::kPoints));

  render::TubeSettings tube;
  tube.renderer = model.renderer.value_or(fuzzy::RendererParameters{});
  const bool speed_first = depth != nullptr && speed != nullptr && speed < depth;
  if (depth != nullptr) tube.depth = speed_first ? 1 : 0;
  if (speed != nullptr) tube.speed = depth != nullptr && !speed_first ? 1 : 0;
  if (depth != nullptr) {
    tube.depth_end_mm = depth->max;
    tube.events = render::TubeEvents(*depth, model.events, tube.renderer.depth_offset_mm);
  }
  const std::shared_ptr<ServoScene> scene(new ServoScene(std::move(specialized), tube, settings.fade_s));
  if (settings.known_cost_s) {
    scene->cost_s_ = *settings.known_cost_s;
  } else if (std::isfinite(settings.largest_cost_s)) {
    scene->cost_s_ = measuredCostS(compiled, settings.largest_cost_s);
  }
  if (scene->cost_s_ > settings.largest_cost_s) {
    return base::fail(ErrorCode::kLimit, "cost of one force of the model", microseconds(scene->cost_s_),
                      "at most " + microseconds(settings.largest_cost_s) + ", so that the servo keeps its time");
  }
  return scene;
}

}  // namespace tactus::haptics
