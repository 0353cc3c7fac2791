// The friction between tube and passage: a spring that slips, for the insertion renderer; and the equation as the paper
// prints it, for plots.
#pragma once

#include "core/render/renderer_state.h"

namespace tactus::render {

// Static friction exactly as printed in the paper (Eq. 3). For plots only, never for a device.

/// F_s = k X - mu V (paper, Section 4.1, Eq. 3), in newtons.
/// `stiffness_n_mm`: k. `displacement_mm`: X. `damping_n_s_mm`: mu. `speed_mm_s`: V.
/// As a resistance, the printed sign is negative damping: the faster the hand moves, the smaller the resistance, and
/// the device feeds mu times the integral of V² into the hand. The equation describes a spring and a damper only if X
/// is measured from the hand to the anchor. So the renderer uses k X + mu V, and this function draws the printed curve
/// for comparison.
/// Thread: any. Real-time safe: yes.
double printedStaticFriction(double stiffness_n_mm, double displacement_mm, double damping_n_s_mm,
                             double speed_mm_s) noexcept;

/// Moves the hand by `moved_mm` against the friction `state.dynamic_n`. Updates stretch, phase, depth and the damping
/// share. The phase must not be kReleased. After `moved_mm` is added to the stretch, the stretch is only ever made
/// smaller; the energy certificate of `step` depends on this. Thread: any. Real-time safe: yes.
void rub(RendererState& state, double moved_mm, const RendererSettings& settings, double dt_s) noexcept;

}  // namespace tactus::render
