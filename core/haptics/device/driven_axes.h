// The axes of a device's frame that have motors, and the share of a direction that lies along them.
#pragma once

#include <array>
#include <cmath>

#include "core/haptics/device/vector3.h"

namespace tactus::haptics {

/// x, y, z of the device's frame; true if there is a motor.
using DrivenAxes = std::array<bool, 3>;

/// Axes by number of motors: the first pushes to the right, the second toward the user, the third up (HID's X, Y and
/// Z).
constexpr DrivenAxes drivenAxes(int force_axes) noexcept { return {force_axes >= 1, force_axes >= 3, force_axes >= 2}; }

/// The part of `v` along the motors.
constexpr Vector3 drivenPart(const Vector3& v, const DrivenAxes& driven) noexcept {
  return {driven[0] ? v.x : 0, driven[1] ? v.y : 0, driven[2] ? v.z : 0};
}

/// The cosine of the angle between `direction` (length 1) and its part along the motors, 0 to 1. If the motors push
/// with 1 N, this is the force along the direction in N.
inline double drivenShare(const Vector3& direction, const DrivenAxes& driven) noexcept {
  const Vector3 part = drivenPart(direction, driven);
  return std::sqrt(dot(part, part));
}

/// The program refuses an insertion axis with a smaller share (26 degrees). The motors have to push harder by the
/// inverse of the share, and the hand also feels the force across the axis: at this share it is 48 % of the force along
/// the axis.
inline constexpr double kLeastDrivenShare = 0.9;

}  // namespace tactus::haptics
