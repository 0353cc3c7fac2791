// What is true of a virtual handle: what a person with ruler and spring scale would find.
#pragma once

#include <array>
#include <cmath>

#include "core/haptics/device/device.h"

#include "tests/vm/device_process.h"

namespace tactus::vm {

struct TrueHandle {
  const char* model;
  int force_axes;
  bool has_switch;  ///< and tells when it is open
  double full_scale_n;
  double mm_per_count;
  double friction_share;        ///< of full scale
  std::array<double, 2> outer;  ///< counts where the tube begins
  std::array<double, 2> inner;  ///< counts further inwards

  double travelCounts() const { return std::hypot(inner[0] - outer[0], inner[1] - outer[1]); }
  double travelMm() const { return travelCounts() * mm_per_count; }
  /// Unit length, in counts.
  std::array<double, 2> inwards() const {
    return {(inner[0] - outer[0]) / travelCounts(), (inner[1] - outer[1]) / travelCounts()};
  }
  /// Where on the axis: 0 is the outer, 1 the inner end.
  std::array<double, 2> at(double share) const {
    return {outer[0] + share * (inner[0] - outer[0]), outer[1] + share * (inner[1] - outer[1])};
  }
  /// Newtons along the insertion axis, inwards positive.
  double newtons(const FeltForce& felt) const { return full_scale_n * (felt.x * inwards()[0] + felt.y * inwards()[1]); }
};

/// HID's X points right and Y toward the person (HID 1.11, 5.9), as x and z of the device's frame do.
inline haptics::Vector3 inDeviceFrame(const std::array<double, 2>& counts) { return {counts[0], 0, counts[1]}; }

}  // namespace tactus::vm
