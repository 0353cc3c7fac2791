// The friction between tube and passage: a spring that slips. Only the insertion renderer uses it.
#pragma once

#include "core/render/renderer_state.h"

namespace tactus::render {

/// Moves the hand by `moved_mm` against the friction `state.dynamic_n`. Updates stretch, phase, depth and the damping
/// share. The phase must not be kReleased. After `moved_mm` is added to the stretch, the stretch is only ever made
/// smaller; the energy certificate of `step` depends on this. Thread: any. Real-time safe: yes.
void rub(RendererState& state, double moved_mm, const RendererSettings& settings, double dt_s) noexcept;

}  // namespace tactus::render
