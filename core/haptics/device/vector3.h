// Three numbers along the axes of a haptic device.
#pragma once

namespace tactus::haptics {

/// A vector in the device's frame: x to the right, y up, z toward the user.
struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;

  bool operator==(const Vector3&) const = default;
};

inline double dot(const Vector3& a, const Vector3& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector3 operator*(double factor, const Vector3& v) noexcept {
  return {factor * v.x, factor * v.y, factor * v.z};
}
inline Vector3 operator+(const Vector3& a, const Vector3& b) noexcept { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector3 operator-(const Vector3& a, const Vector3& b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

}  // namespace tactus::haptics
