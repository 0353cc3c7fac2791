// Static friction exactly as the paper prints it (Eq. 3): for plots only, never for a device.
#pragma once

namespace tactus::render {

/// F_s = k X - mu V (paper, Section 4.1, Eq. 3), in newtons.
/// `stiffness_n_mm`: k. `displacement_mm`: X. `damping_n_s_mm`: mu. `speed_mm_s`: V.
/// Read as a resistance, the printed sign is negative damping: the faster the hand moves, the less it is resisted, and
/// the device feeds mu times the integral of V² into the hand. The equation agrees with a spring and a damper only
/// where X is measured from the hand to the anchor. The renderer therefore resists with k X + mu V, and this function
/// draws the printed curve beside it.
/// Thread: any. Real-time safe: yes.
double printedStaticFriction(double stiffness_n_mm, double displacement_mm, double damping_n_s_mm,
                             double speed_mm_s) noexcept;

}  // namespace tactus::render
