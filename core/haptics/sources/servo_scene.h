// A model prepared for the servo: compiled, specialized for its constant inputs, its cost measured.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "core/render/tube_scene.h"

namespace tactus::haptics {

/// Values of the conditions by input id: of all inputs but the way and the rate, which the renderer moves. A value
/// outside its universe is clamped.
using Conditions = std::map<std::string, double>;

struct SceneSettings {
  /// Duration of the fade from old to new force at a change of scene, s, [0, 60]. A neck-flexion gesture takes about 1
  /// s.
  double fade_s = 0.05;
  /// Longest time for one force. A slower model is refused, because the servo has 1 ms for everything. Infinite: no
  /// model is refused, and the result does not depend on the clock.
  double largest_cost_s = 200e-6;
  /// What one force of the model costs, measured before by `measuredCostS`, s. Nothing: measured by `make`.
  std::optional<double> known_cost_s;
};

/// Cost of one force of `compiled`: the slowest of 32 points, spread over all inputs, each the fastest of five rounds;
/// s, including the reading of the clock. No scene of the model costs more. It depends on the shape of the model
/// (experts, rules, terms), hardly on its numbers. Stops at the first point above `enough_s`.
double measuredCostS(const fuzzy::CompiledModel& compiled, double enough_s = SceneSettings().largest_cost_s);

/// Immutable; made and freed by the thread that posts it, only read by the servo.
class ServoScene : public render::TubeScene {
 public:
  /// Refused with one sentence: an invalid model, a depth, speed or force in other units than mm, mm/s and N (a
  /// variable without a unit is taken as it is), a condition that is missing, unknown or not finite, a fade out of
  /// range, a model that is too slow (its cost exceeds the budget).
  static base::Result<std::shared_ptr<const ServoScene>> make(const fuzzy::ForceModel& model,
                                                              const Conditions& conditions,
                                                              const SceneSettings& settings = {});
  /// The same for a model that is compiled already: `compiled` is made from `model`.
  static base::Result<std::shared_ptr<const ServoScene>> make(const fuzzy::ForceModel& model,
                                                              const fuzzy::CompiledModel& compiled,
                                                              const Conditions& conditions,
                                                              const SceneSettings& settings = {});

  /// Duration of the fade from the scene before to this one, s.
  double fadeS() const noexcept { return fade_s_; }
  /// Cost of one force of the model, s: measured or as given. 0: not asked for, because the budget is infinite.
  double costS() const noexcept { return cost_s_; }

 private:
  ServoScene(fuzzy::Scene scene, const render::TubeSettings& settings, double fade_s)
      : TubeScene(std::move(scene), settings), fade_s_(fade_s) {}

  double fade_s_;
  double cost_s_ = 0;
};

}  // namespace tactus::haptics
