// A model made ready for the servo: compiled, specialised to what does not change for now, its cost measured.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/scene.h"
#include "core/render/insertion_renderer.h"

namespace tactus::haptics {

/// Which inputs the renderer moves; all others are conditions. The defaults are those of the NGT model. An input that
/// the model lacks is not moved, and neither is one whose name here is empty.
struct MovedInputs {
  std::string depth = "depth";
  std::string speed = "speed";
};

/// Values of the conditions by input id, e.g. lubrication and neck flexion. Outside its universe a value is clamped.
using Conditions = std::map<std::string, double>;

struct SceneSettings {
  MovedInputs moved;
  /// Fade of the difference between old and new force at the hand-over, s, [0, 60]. A neck-flexion gesture takes about
  /// 1 s.
  double fade_s = 0.05;
  /// A model that needs longer for one force is refused: the servo has 1 ms for everything. Infinite: never refused,
  /// and then nothing depends on the clock of this machine.
  double largest_cost_s = 200e-6;
};

/// Immutable; made by whoever posts it, only read by the servo, freed by whoever posted it.
class ServoScene {
 public:
  /// Refused with one sentence: an invalid model, a depth, speed or force in other units than mm, mm/s and N (a
  /// variable without a unit is taken as it is), a condition that is missing, unknown or not finite, a fade out of
  /// range, a model that is too slow (at one of the points tried, all over its depth and speed, even the fastest of
  /// several rounds exceeds the budget).
  static base::Result<std::shared_ptr<const ServoScene>> make(const fuzzy::ForceModel& model,
                                                              const Conditions& conditions,
                                                              const SceneSettings& settings = {});

  /// The force where the renderer asks; bit by bit that of CompiledModel::evaluate. Real-time safe: yes.
  render::ModelForce force(const render::ForcePoint& point) const noexcept;

  /// Another number for each scene of this process, never 0: an address may be used again. Nothing is computed from it.
  std::uint64_t serial() const noexcept { return serial_; }
  const fuzzy::RendererParameters& renderer() const noexcept { return renderer_; }
  /// End of the model's depth, offset included; infinite for a model without depth.
  double depthEndMm() const noexcept { return depth_end_mm_; }
  double fadeS() const noexcept { return fade_s_; }
  /// What the slowest of the points tried cost, s, with the reading of the clock.
  double costS() const noexcept { return cost_s_; }

 private:
  explicit ServoScene(fuzzy::Scene scene);

  fuzzy::Scene scene_;
  std::uint64_t serial_;
  fuzzy::RendererParameters renderer_;
  std::optional<std::size_t> depth_;  ///< place among the free inputs
  std::optional<std::size_t> speed_;
  double depth_end_mm_ = 0;
  double fade_s_ = 0.05;
  double cost_s_ = 0;
};

}  // namespace tactus::haptics
