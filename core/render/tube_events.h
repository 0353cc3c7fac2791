// The events of a model as a tube renders them: what the tip has passed in a stroke takes a share of the model's force.
// Example: a vein wall ends to hold fully at 4 mm with a share of 0.6. From 4 mm on, until the next stroke, the force
// is multiplied by 1 - 0.6 m, where m is the membership of the depth in the vein wall.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"
#include "core/render/renderer_state.h"

namespace tactus::render {

/// Immutable. The place of an event is the end of the core of its term (fuzzy::endOfCore).
class TubeEvents {
 public:
  TubeEvents() = default;
  /// `events` name terms of `way`. `offset_mm`: depth of the model where the depth of the tube is 0.
  TubeEvents(const fuzzy::Variable& way, std::span<const fuzzy::TubeEvent> events, double offset_mm);

  /// How many events are done where the tip has been as deep as `deepest_mm`, a depth of the tube.
  /// Thread: any. Real-time safe: yes.
  std::size_t reached(double deepest_mm) const noexcept;
  /// What these events leave of the force at `depth_mm`, a depth of the model: in (0, 1], 1 without events. A depth
  /// outside of the universe is clamped to it. Thread: any. Real-time safe: yes.
  double left(double deepest_mm, double depth_mm) const noexcept;

  bool operator==(const TubeEvents&) const = default;

 private:
  struct Event {
    double place_mm = 0;  ///< a depth of the tube
    double share = 0;
    fuzzy::MembershipFunction membership;

    bool operator==(const Event&) const = default;
  };

  double min_mm_ = 0;
  double max_mm_ = 0;
  std::vector<Event> events_;
};

/// How deep the tip has been in the stroke. While the hand does not hold the tube that is where the tip is: so the next
/// stroke has the events ahead of the tip before it, and those behind it stay done. Plain data.
struct StrokeReach {
  double deepest_mm = 0;
  std::size_t done = 0;  ///< events

  /// Call it once a tick, before the model is asked. `state`: of the tick before. True: other events are done than at
  /// the last call, so the model has to be asked anew. Real-time safe: yes.
  bool follow(const RendererState& state, const TubeEvents& events) noexcept;

  bool operator==(const StrokeReach&) const = default;
};

}  // namespace tactus::render
