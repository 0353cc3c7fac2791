// The calibration of one device: force at full scale, signs, friction, mm per count, insertion axis.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/haptics/device/axis_mapping.h"
#include "core/haptics/device/vector3.h"

namespace tactus::haptics {

/// One entry per device and serial number. Vectors are in the device's frame (vector3.h).
struct DeviceCalibration {
  std::string device;                    ///< DeviceInfo::id
  std::string serial;                    ///< DeviceInfo::serial; may be empty
  double full_scale_n = 0;               ///< [0.05, 500]: force at the device's largest command
  Vector3 force_sign{1, 1, 1};           ///< each 1 or -1; -1 if the device pushes against the commanded direction
  double mm_per_count = 0;               ///< [1e-6, 100]
  Vector3 inwards{0, 0, -1};             ///< unit length: direction of insertion
  Vector3 origin_mm;                     ///< the point where the axis position is 0
  std::optional<double> friction_in_n;   ///< [0, full_scale_n]: dry friction of the device against insertion
  std::optional<double> friction_out_n;  ///< dry friction against withdrawal
  bool silent_when_still = false;        ///< the device sends nothing at rest
  std::string measured_at;               ///< UTC, e.g. 2026-11-21T08:00:00Z
  std::string procedure;                 ///< name of the measuring procedure, e.g. `guided 2`

  bool operator==(const DeviceCalibration&) const = default;
};

/// Returns an error if a value is not finite or outside its range above.
base::Result<void> checkCalibration(const DeviceCalibration& calibration);

/// Returns an error if the vector is not finite or not of length 1. `key`: its name in the message.
base::Result<void> checkDirection(const char* key, const Vector3& direction);

/// The insertion axis of a checked calibration.
AxisMapping axisOf(const DeviceCalibration& calibration);

}  // namespace tactus::haptics
