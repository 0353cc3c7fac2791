// The three postures of the neck in which the head is drawn.
#pragma once

namespace tactus::workbench::anatomy {

enum class Posture { kUpright, kHalfFlexed, kChinOnChest };

/// The angle between head and trunk in the drawing, degrees. The model's neck flexion of 0 to 90 is nominal: its words
/// Small, Medium and Large are drawn as 0, 33 and 66 degrees of active flexion (normal: 60).
constexpr double drawnFlexionDeg(Posture posture) { return 33.0 * static_cast<int>(posture); }

}  // namespace tactus::workbench::anatomy
