// Converts between a device's frame and the insertion axis: one number for the position, one for the force.
#pragma once

#include "core/base/error.h"
#include "core/haptics/device/vector3.h"

namespace tactus::haptics {

/// A unit direction and a zero point. The default direction is level and points away from the user, so that the weight
/// of hand and stylus does not act along the axis.
class AxisMapping {
 public:
  AxisMapping() = default;
  /// `inwards`: direction of insertion, of any length > 0. `origin_mm`: the point where the axis position is 0. Returns
  /// an error if a number is not finite or `inwards` has the length 0.
  static base::Result<AxisMapping> make(const Vector3& inwards, const Vector3& origin_mm = {});

  const Vector3& inwards() const noexcept { return inwards_; }
  const Vector3& originMm() const noexcept { return origin_mm_; }

  /// Position along the axis, positive inwards. Real-time safe: yes.
  double positionMm(const Vector3& position_mm) const noexcept { return dot(position_mm - origin_mm_, inwards_); }
  double speedMmS(const Vector3& velocity_mm_s) const noexcept { return dot(velocity_mm_s, inwards_); }
  /// The force on the hand for a resistance against insertion. Real-time safe: yes.
  Vector3 forceOnHand(double resistance_n) const noexcept { return -resistance_n * inwards_; }

 private:
  Vector3 inwards_{0, 0, -1};
  Vector3 origin_mm_;
};

}  // namespace tactus::haptics
