// The renderer's state between two ticks, its input at a tick, and its settings.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "core/fuzzy/renderer_parameters.h"
#include "core/render/low_pass.h"

namespace tactus::render {

enum class Phase : std::uint8_t {
  kReleased,    ///< the hand does not hold the tube: no force, no motion counts
  kStuck,       ///< static friction: the tube yields like a spring and does not advance
  kSlidingIn,   ///< dynamic friction against insertion; the depth grows
  kSlidingOut,  ///< dynamic friction against withdrawal; the depth falls
};

/// The reason why the renderer released the force by itself. It engages again after `enabled` has been false.
enum class Fault : std::uint8_t { kNone, kPosition, kForce, kTime };  ///< the quantity out of range

/// The inputs of the model that the renderer moves. The caller sets the other inputs (lubrication, neck flexion).
struct ForcePoint {
  double depth_mm = 0;    ///< depth of the model, including the offset
  double speed_mm_s = 0;  ///< >= 0: filtered speed of the slip inwards; 0 in every other phase

  bool operator==(const ForcePoint&) const = default;
};

/// The model's answer at a ForcePoint. A force below 0 counts as 0; a force that is not finite is a fault.
struct ModelForce {
  double force_n = 0;
  bool fired = false;  ///< false: no rule fired, and `force_n` is the model's default
};

/// One stroke: from a press to the release.
struct StrokeSpan {
  std::uint32_t number = 0;  ///< from 1; 0: no stroke yet
  double start_s = 0;        ///< times as RendererState::time_s
  double end_s = 0;          ///< end, or the last tick while the stroke lasts
  double start_depth_mm = 0;
  double end_depth_mm = 0;

  bool operator==(const StrokeSpan&) const = default;
};

/// Plain data: copy it, compare it, start with a default one. To start at another depth than the entry, set
/// `depth_mm`.
struct RendererState {
  Phase phase = Phase::kReleased;
  Fault fault = Fault::kNone;
  double time_s = 0;    ///< sum of the ticks so far
  double depth_mm = 0;  ///< depth of the tube: the sum of all slip
  double force_n = 0;   ///< resistance along the axis; the force on the hand is its negative
  StrokeSpan stroke;

  std::optional<double> position_mm;  ///< of the last tick
  double stretch_mm = 0;              ///< z: lead of the hand over the tube
  double stiffness_n_mm = 0;          ///< of the last tick, to detect a change
  double clip_n = 0;                  ///< sliding: force above which the spring slips; relaxes to dynamic friction
  double stiction = 0;                ///< stuck: share of the break-away surplus built up at rest, [0, 1]
  double slow_s = 0;                  ///< time for which a sliding tube has been slower than stick_speed_mm_s
  double damping_share = 0;           ///< 1 after a long stuck phase, 0 while sliding
  LowPass speed_mm_s;                 ///< of the hand
  LowPass slip_speed_mm_s;            ///< of the tube
  double fading_n = 0;                ///< remaining force of the last stroke, on its way to 0
  double fading_rate_n_s = 0;

  double dynamic_n = 0;             ///< F_d as rendered: follows `model_n` at slew_n_s or slower
  double model_n = 0;               ///< the last F_d that fired; before that, the model's default
  bool any_fired = false;           ///< a rule has fired since the start
  bool held = false;                ///< no rule fires at the present point, so `model_n` is held
  std::optional<ForcePoint> asked;  ///< the point at which the model gave `model_n`
  std::uint64_t conditions = 0;     ///< RendererInput::conditions at that time

  bool operator==(const RendererState&) const = default;
};

/// The input of one tick.
struct RendererInput {
  double position_mm = 0;           ///< of the hand along the axis, inwards positive
  bool enabled = false;             ///< button, pedal or key, debounced; false releases at once
  std::uint64_t conditions = 0;     ///< changes if the model, lubrication or neck flexion changes
  std::optional<ModelForce> force;  ///< the model's force if `forceNeeded` gave a point; otherwise ignored
};

/// The settings for all ticks until the caller changes them.
struct RendererSettings {
  fuzzy::RendererParameters friction;  ///< inside the ranges of fuzzy::kRendererFields; validated with the model
  double force_cap_n = 2.0;            ///< >= 0, largest force. If it is below the friction, the tube slips at the cap
  /// End of the model's depth, including the offset: the tube goes no deeper. Default: no end.
  double depth_end_mm = std::numeric_limits<double>::infinity();
};

}  // namespace tactus::render
