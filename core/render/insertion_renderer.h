// The insertion renderer: the force on the hand while it pushes the tube in, stroke by stroke (paper, Section 4).
#pragma once

#include <optional>

#include "core/render/renderer_state.h"

namespace tactus::render {

/// The hand engages only below this speed, so that a press in full motion does not grab.
inline constexpr double kEngageSpeedMmS = 300;
/// Time from the release until the force of the stroke is zero. The design allows no more.
inline constexpr double kReleaseFadeS = 0.03;
/// Fade times of the damping at the start and the end of the stuck phase. A faster change is felt as a click.
inline constexpr double kDampingFadeInS = 0.02;
inline constexpr double kDampingFadeOutS = 0.01;
/// Largest share of F_d for the damping. It must not carry the force, because it is computed from quantized positions.
inline constexpr double kLargestDampingShare = 0.2;
/// Time constant with which the resistance against withdrawal vanishes at the entry, where the tube is out.
inline constexpr double kTubeOutS = 0.01;
/// A position that is further from 0 than this, or not finite, is a fault. So is a tick outside these lengths.
inline constexpr double kFarthestMm = 1e6;
inline constexpr double kShortestTickS = 1e-6;
inline constexpr double kLongestTickS = 1;

/// The point at which the caller must evaluate the model before this tick's `step`. Nothing while released, and nothing
/// if point and conditions are those of the last answer (for example while stuck).
/// Thread: any. Real-time safe: yes.
std::optional<ForcePoint> forceNeeded(const RendererState& state, const RendererInput& input,
                                      const RendererSettings& settings) noexcept;

/// The state after one tick: an elasto-plastic friction element (Hayward and Armstrong 2000) with the model's force as
/// its dynamic friction.
/// Stuck: the resistance is k z + mu v up to F_m = (1 + tau) F_d. Then the tube slips: F_m relaxes to F_d, and all slip
/// counts as depth. docs/renderer.md describes the states, parameters and measurements.
/// `dt_s`: [kShortestTickS, kLongestTickS], time since the last tick. If the model is needed and `input.force` is
/// empty, the last answer stays in effect and the need remains. Input out of range releases the force with a fault. The
/// result is always finite.
/// Guarantee (energy certificate): suppose k z of the last tick is held while the hand moves by dx. Then the sum of k z
/// dx + k dx² / 2 over all ticks is never below the change of k z² / 2. So the spring returns only energy that the hand
/// put in.
/// Thread: any. Real-time safe: yes (a pure function: no allocation, no lock, bounded time).
RendererState step(const RendererState& state, const RendererInput& input, const RendererSettings& settings,
                   double dt_s) noexcept;

/// `step` with the model as a function. `force_at(ForcePoint)` returns a ModelForce; it is called only if needed.
/// Real-time safe: yes, if `force_at` is.
template <typename ForceAt>
RendererState stepAsking(const RendererState& state, RendererInput input, const RendererSettings& settings, double dt_s,
                         ForceAt&& force_at) {
  if (const auto point = forceNeeded(state, input, settings)) input.force = force_at(*point);
  return step(state, input, settings, dt_s);
}

}  // namespace tactus::render
