// What the insertion renderer remembers between two ticks, what it is told at a tick, and what it may be set to.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "core/fuzzy/renderer_parameters.h"
#include "core/render/low_pass.h"

namespace tactus::render {

enum class Phase : std::uint8_t {
  kReleased,    ///< the hand does not hold the tube: no force, nothing counts
  kStuck,       ///< static friction: the tube gives like a spring and does not advance
  kSlidingIn,   ///< dynamic friction against insertion; the depth grows
  kSlidingOut,  ///< dynamic friction against withdrawal; the depth falls
};

/// Why the renderer let go by itself. It engages again after `enabled` has been off.
enum class Fault : std::uint8_t { kNone, kPosition, kForce, kTime };  ///< what was out of range

/// Where the model is asked: its inputs that the renderer moves. Lubrication and neck flexion are the caller's.
struct ForcePoint {
  double depth_mm = 0;    ///< depth of the model, offset included
  double speed_mm_s = 0;  ///< >= 0: filtered speed of the slip inwards, 0 in every other phase

  bool operator==(const ForcePoint&) const = default;
};

/// The model's answer at a ForcePoint. Below 0 counts as 0; not finite is a fault.
struct ModelForce {
  double force_n = 0;
  bool fired = false;  ///< false: no rule fired, and `force_n` is the model's default
};

/// One stroke: from a press to the release.
struct Stroke {
  std::uint32_t number = 0;  ///< from 1; 0: there was none yet
  double start_s = 0;        ///< times as RendererState::time_s
  double end_s = 0;          ///< the last tick so far while the stroke lasts
  double start_depth_mm = 0;
  double end_depth_mm = 0;

  bool operator==(const Stroke&) const = default;
};

/// Plain data: copy it, compare it, start with a default one. To start elsewhere than at the nostril set `depth_mm`.
struct RendererState {
  Phase phase = Phase::kReleased;
  Fault fault = Fault::kNone;
  double time_s = 0;    ///< sum of the ticks so far
  double depth_mm = 0;  ///< how far the tube is in: slip counted, nothing else
  double force_n = 0;   ///< resistance along the axis; the force on the hand is its negative
  Stroke stroke;

  std::optional<double> position_mm;  ///< of the last tick
  double stretch_mm = 0;              ///< z: how far the hand is ahead of the tube
  double stiffness_n_mm = 0;          ///< of the last tick, to notice a change
  double clip_n = 0;                  ///< while sliding: the spring slips above this; relaxes to dynamic friction
  double stiction = 0;                ///< while stuck: share of the break-away surplus that rest has built up, [0, 1]
  double slow_s = 0;                  ///< how long a sliding tube has been slower than stick_speed_mm_s
  double damping_share = 0;           ///< 1 when stuck for long, 0 when sliding
  LowPass speed_mm_s;                 ///< of the hand
  LowPass slip_speed_mm_s;            ///< of the tube
  double fading_n = 0;                ///< rest of the last stroke's force, on its way to 0
  double fading_rate_n_s = 0;

  double dynamic_n = 0;             ///< F_d as rendered: follows `model_n` no faster than slew_n_s
  double model_n = 0;               ///< the last F_d that fired; the model's default before any did
  bool any_fired = false;           ///< a rule has fired since the start
  bool held = false;                ///< no rule fires at the present point: `model_n` is held
  std::optional<ForcePoint> asked;  ///< where `model_n` was asked for
  std::uint64_t conditions = 0;     ///< RendererInput::conditions at that time

  bool operator==(const RendererState&) const = default;
};

/// One tick.
struct RendererInput {
  double position_mm = 0;           ///< of the hand along the axis, inwards positive
  bool enabled = false;             ///< button, pedal or key, debounced; false lets go at once
  std::uint64_t conditions = 0;     ///< another number whenever the model, lubrication or neck flexion is another one
  std::optional<ModelForce> force;  ///< the answer where `forceNeeded` asked; not read where it did not
};

/// What holds for all ticks until somebody changes it.
struct RendererSettings {
  fuzzy::RendererParameters friction;  ///< within fuzzy::kRendererFields, as validated with the model
  double force_cap_n = 2.0;            ///< >= 0; no force is larger. Lower than the friction, the tube slips at the cap
  /// End of the model's depth, offset included: the tube goes no deeper. The default is no end.
  double depth_end_mm = std::numeric_limits<double>::infinity();
};

}  // namespace tactus::render
