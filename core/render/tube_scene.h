// A model under fixed conditions, as the insertion asks it: depth and speed in, force out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/scene.h"
#include "core/render/renderer_state.h"
#include "core/render/tube_events.h"

namespace tactus::render {

/// What the insertion must know of the model beside its force.
struct TubeSettings {
  std::optional<std::size_t> depth;  ///< place among the free inputs of the scene; nothing: the model has no depth
  std::optional<std::size_t> speed;
  double depth_end_mm = std::numeric_limits<double>::infinity();  ///< end of the model's depth, including the offset
  fuzzy::RendererParameters renderer;
  TubeEvents events;
};

/// Refuses a depth, a speed or a force in other units than mm, mm/s and N. A variable without a unit, or with the unit
/// `1`, is taken as it is. Null: the model has no such input.
base::Result<void> checkTubeUnits(const fuzzy::Variable* depth, const fuzzy::Variable* speed,
                                  const fuzzy::Variable& output);

/// Immutable. Copies have the same serial number.
class TubeScene {
 public:
  /// `scene`: its free inputs are those that `settings` names, and no other.
  TubeScene(fuzzy::Scene scene, const TubeSettings& settings);

  /// The force of the model, without its events. Equal bit by bit to CompiledModel::evaluate. Thread: any. Real-time
  /// safe: yes.
  ModelForce force(const ForcePoint& point) const noexcept;

  /// A number > 0, different for each scene made in this process. It identifies a scene better than its address, which
  /// may be reused.
  std::uint64_t serial() const noexcept { return serial_; }
  const fuzzy::RendererParameters& renderer() const noexcept { return settings_.renderer; }
  const TubeEvents& events() const noexcept { return settings_.events; }
  /// End of the model's depth, including the offset; infinite for a model without depth.
  double depthEndMm() const noexcept { return settings_.depth_end_mm; }

 private:
  fuzzy::Scene scene_;
  TubeSettings settings_;
  std::uint64_t serial_;
};

}  // namespace tactus::render
