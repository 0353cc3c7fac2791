// The insertion renderer: what the hand feels while it pushes the tube in, stroke by stroke (paper, Section 4).
#pragma once

#include <optional>

#include "core/render/renderer_state.h"

namespace tactus::render {

/// The hand engages below this speed only, so that a press in full motion does not grab.
inline constexpr double kEngageSpeedMmS = 300;
/// The force of a stroke is gone this long after the release; the design allows no more.
inline constexpr double kReleaseFadeS = 0.03;
/// Damping comes and goes with the stuck phase in these times; faster is felt as a click.
inline constexpr double kDampingFadeInS = 0.02;
inline constexpr double kDampingFadeOutS = 0.01;
/// Damping is at most this share of F_d: it is computed from counted positions and must never carry the force.
inline constexpr double kLargestDampingShare = 0.2;
/// At the nostril the resistance against withdrawal vanishes with this time constant: the tube is out.
inline constexpr double kTubeOutS = 0.01;
/// A position further from 0 than this, or not finite, is a fault; so is a tick outside these lengths.
inline constexpr double kFarthestMm = 1e6;
inline constexpr double kShortestTickS = 1e-6;
inline constexpr double kLongestTickS = 1;

/// Where the model has to be asked before this tick's `step`, or nothing: not while released, and not while the point
/// and the conditions are those of the last answer (stuck, for instance).
/// Thread: any. Real-time safe: yes.
std::optional<ForcePoint> forceNeeded(const RendererState& state, const RendererInput& input,
                                      const RendererSettings& settings) noexcept;

/// The state after one tick: an elasto-plastic friction element (Hayward and Armstrong 2000) whose dynamic friction is
/// the model's force. Stuck, the resistance is k z + mu v up to F_m = (1 + tau) F_d; then the tube slips, F_m relaxes
/// to F_d, and all slip counts as depth. docs/renderer.md has the states, parameters and measurements.
/// `dt_s` in [kShortestTickS, kLongestTickS]: time since the last tick. Where the model is needed and `input.force` is
/// empty, the last answer stays in force and remains needed. Input out of range lets go with a fault; the result is
/// always finite. Guarantee (energy certificate): with k z of the last tick held while the hand moves by dx, the sum of
/// k z dx + k dx² / 2 over all ticks is never below the change of k z² / 2: the spring gives back only what was put in.
/// Thread: any. Real-time safe: yes (a pure function: no allocation, no lock, bounded time).
RendererState step(const RendererState& state, const RendererInput& input, const RendererSettings& settings,
                   double dt_s) noexcept;

/// `step` with the model as a function: `force_at(ForcePoint)` returns a ModelForce and is called only where needed.
/// Real-time safe: where `force_at` is.
template <typename ForceAt>
RendererState stepAsking(const RendererState& state, RendererInput input, const RendererSettings& settings, double dt_s,
                         ForceAt&& force_at) {
  if (const auto point = forceNeeded(state, input, settings)) input.force = force_at(*point);
  return step(state, input, settings, dt_s);
}

}  // namespace tactus::render
