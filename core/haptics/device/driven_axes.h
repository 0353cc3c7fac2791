// Along which axes of its frame a device has motors, and how much of a direction lies along them.
#pragma once

#include <array>
#include <cmath>

#include "core/haptics/device/vector3.h"

namespace tactus::haptics {

/// x, y, z of the device's frame; true: there is a motor.
using DrivenAxes = std::array<bool, 3>;

/// The first motor pushes to the right, the second toward the person, a third one up (HID's X, Y and Z).
constexpr DrivenAxes drivenAxes(int force_axes) noexcept { return {force_axes >= 1, force_axes >= 3, force_axes >= 2}; }

/// `v` without what lies across the motors.
constexpr Vector3 drivenPart(const Vector3& v, const DrivenAxes& driven) noexcept {
  return {driven[0] ? v.x : 0, driven[1] ? v.y : 0, driven[2] ? v.z : 0};
}

/// The cosine between `direction`, of length 1, and the motors, 0 to 1. A push of 1 N of the motors is felt as so many
/// newtons along the direction.
inline double drivenShare(const Vector3& direction, const DrivenAxes& driven) noexcept {
  const Vector3 part = drivenPart(direction, driven);
  return std::sqrt(dot(part, part));
}

/// An insertion axis with less is refused (26 degrees). The motors have to push harder by the inverse of the share, and
/// what they push across the axis is felt too: at this share 48 % of the force along it.
inline constexpr double kLeastDrivenShare = 0.9;

}  // namespace tactus::haptics
