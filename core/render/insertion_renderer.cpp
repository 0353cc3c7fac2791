#include "core/render/insertion_renderer.h"

#include <algorithm>
#include <cmath>

#include "core/render/friction.h"

namespace tactus::render {

namespace {

bool usable(double position_mm) noexcept { return std::abs(position_mm) <= kFarthestMm; }

bool engages(const RendererState& state, const RendererInput& input) noexcept {
  return input.enabled && state.fault == Fault::kNone && usable(input.position_mm) &&
         (state.phase != Phase::kReleased || std::abs(state.speed_mm_s.value) < kEngageSpeedMmS);
}

/// The answer to the present question, if there was one and it was answered.
const ModelForce* answer(const RendererState& state, const RendererInput& input,
                         const RendererSettings& settings) noexcept {
  return input.force && forceNeeded(state, input, settings) ? &*input.force : nullptr;
}

Fault faultOf(const RendererState& state, const RendererInput& input, const ModelForce* force, double dt_s) noexcept {
  if (!(dt_s >= kShortestTickS && dt_s <= kLongestTickS)) return Fault::kTime;
  if (!usable(input.position_mm)) return Fault::kPosition;
  if (!input.enabled) return Fault::kNone;
  if (state.fault != Fault::kNone) return state.fault;
  return force != nullptr && !std::isfinite(force->force_n) ? Fault::kForce : Fault::kNone;
}

/// The way of the hand since the last tick; 0 where either end is unknown.
double move(RendererState& next, const RendererInput& input, const RendererSettings& settings, double dt_s) noexcept {
  if (!usable(input.position_mm)) {
    next.position_mm.reset();
    next.speed_mm_s = {};
    return 0;
  }
  const double moved_mm = next.position_mm ? input.position_mm - *next.position_mm : 0;
  next.position_mm = input.position_mm;
  next.speed_mm_s = filtered(next.speed_mm_s, moved_mm / dt_s, settings.friction.velocity_filter_hz, dt_s);
  return moved_mm;
}

void take(RendererState& next, const ModelForce& force, const ForcePoint& point, std::uint64_t conditions) noexcept {
  next.asked = point;
  next.conditions = conditions;
  next.held = !force.fired;
  if (force.fired || !next.any_fired) next.model_n = std::max(0.0, force.force_n);
  next.any_fired = next.any_fired || force.fired;
}

void letGo(RendererState& next) noexcept {
  if (next.phase != Phase::kReleased) {
    next.fading_n = next.force_n;
    next.fading_rate_n_s = std::abs(next.force_n) / kReleaseFadeS;
  }
  next.phase = Phase::kReleased;
  next.stretch_mm = 0;
  next.clip_n = 0;
  next.slow_s = 0;
  next.damping_share = 0;
}

/// Anchors at the present position, so that the force begins at zero. The tube has rested: full static friction.
void engage(RendererState& next, const RendererSettings& settings) noexcept {
  next.phase = Phase::kStuck;
  next.stretch_mm = 0;
  next.stiffness_n_mm = settings.friction.stiffness_n_mm;
  next.stiction = 1;
  next.dynamic_n = next.model_n;
  next.stroke = {next.stroke.number + 1, next.time_s, next.time_s, next.depth_mm, next.depth_mm};
}

void fade(RendererState& next, double dt_s) noexcept {
  const double step_n = next.fading_rate_n_s * dt_s;
  next.fading_n = std::abs(next.fading_n) > step_n ? next.fading_n - std::copysign(step_n, next.fading_n) : 0;
}

double resistance(const RendererState& next, const RendererSettings& settings) noexcept {
  const double most_n = kLargestDampingShare * next.dynamic_n;
  const double damping_n = next.damping_share * settings.friction.damping_n_s_mm * next.speed_mm_s.value;
  const double force_n =
      settings.friction.stiffness_n_mm * next.stretch_mm + std::clamp(damping_n, -most_n, most_n) + next.fading_n;
  return std::clamp(force_n, -settings.force_cap_n, settings.force_cap_n);
}

}  // namespace

std::optional<ForcePoint> forceNeeded(const RendererState& state, const RendererInput& input,
                                      const RendererSettings& settings) noexcept {
  if (!engages(state, input)) return std::nullopt;
  const bool in = state.phase == Phase::kSlidingIn;
  const ForcePoint point{state.depth_mm + settings.friction.depth_offset_mm,
                         in ? std::max(0.0, state.slip_speed_mm_s.value) : 0};
  if (state.asked == point && state.conditions == input.conditions) return std::nullopt;
  return point;
}

RendererState step(const RendererState& state, const RendererInput& input, const RendererSettings& settings,
                   double dt_s) noexcept {
  RendererState next = state;
  const ModelForce* force = answer(state, input, settings);
  next.fault = faultOf(state, input, force, dt_s);
  // A tick of unknown length cannot fade: its force ends here.
  if (next.fault == Fault::kTime) {
    letGo(next);
    next.force_n = next.fading_n = 0;
    next.position_mm.reset();
    next.speed_mm_s = next.slip_speed_mm_s = {};
    return next;
  }
  next.time_s += dt_s;
  const double moved_mm = move(next, input, settings, dt_s);
  if (force != nullptr && next.fault == Fault::kNone)
    take(next, *force, *forceNeeded(state, input, settings), input.conditions);
  const double slew_n = settings.friction.slew_n_s * dt_s;
  if (next.fault != Fault::kNone || !engages(state, input))
    letGo(next);
  else if (state.phase == Phase::kReleased)
    engage(next, settings);
  else {
    next.dynamic_n += std::clamp(next.model_n - next.dynamic_n, -slew_n, slew_n);
    rub(next, moved_mm, settings, dt_s);
  }
  next.slip_speed_mm_s = filtered(next.slip_speed_mm_s, (next.depth_mm - state.depth_mm) / dt_s,
                                  settings.friction.velocity_filter_hz, dt_s);
  if (state.phase != Phase::kReleased) {
    next.stroke.end_s = next.time_s;
    next.stroke.end_depth_mm = next.depth_mm;
  }
  fade(next, dt_s);
  next.force_n = resistance(next, settings);
  return next;
}

}  // namespace tactus::render
