// The friction between tube and passage: a spring that slips. Used by the insertion renderer alone.
#pragma once

#include "core/render/renderer_state.h"

namespace tactus::render {

/// Moves the hand by `moved_mm` against the friction `state.dynamic_n`: stretch, phase, depth and the share of damping.
/// The phase is not kReleased. After the stretch has grown by `moved_mm` it is only ever made smaller, which is what
/// the energy certificate of `step` rests on. Thread: any. Real-time safe: yes.
void rub(RendererState& state, double moved_mm, const RendererSettings& settings, double dt_s) noexcept;

}  // namespace tactus::render
