// What was measured on one device: newtons at full scale, signs, own friction, millimetres, the insertion axis.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/axis_mapping.h"
#include "core/haptics/vector3.h"

namespace tactus::haptics {

/// One entry per device and serial number. Vectors are in the device's frame (vector3.h).
struct DeviceCalibration {
  std::string device;                    ///< DeviceInfo::id
  std::string serial;                    ///< DeviceInfo::serial; may be empty
  double full_scale_n = 0;               ///< [0.05, 500]: the force at the device's largest value
  Vector3 force_sign{1, 1, 1};           ///< each 1 or -1: -1 where the device pushes against the asked direction
  double mm_per_count = 0;               ///< [1e-6, 100]
  Vector3 inwards{0, 0, -1};             ///< unit length: the way the tube goes
  Vector3 origin_mm;                     ///< where the axis position is 0
  std::optional<double> friction_in_n;   ///< [0, full_scale_n]: own dry friction of the device against insertion
  std::optional<double> friction_out_n;  ///< against withdrawal
  bool silent_when_still = false;        ///< the device sends nothing while nothing moves
  std::string measured_at;               ///< UTC, e.g. 2026-11-21T08:00:00Z
  std::string procedure;                 ///< how it was measured, e.g. `guided 1`

  bool operator==(const DeviceCalibration&) const = default;
};

/// Refused: a value outside the ranges above, or not finite.
base::Result<void> checkCalibration(const DeviceCalibration& calibration);

/// The insertion axis of a checked calibration.
AxisMapping axisOf(const DeviceCalibration& calibration);

/// The entries of the JSON file `path`; none where there is no file. Refused, with the place: what is not of this
/// format, an unknown or missing key, nonsense numbers, two entries of one device, a file above 1 MiB.
base::Result<std::vector<DeviceCalibration>> readCalibrations(const std::string& path);

/// Puts `calibration` into the file, in the place of an older entry of the same device and serial number. The file
/// appears whole or stays as it was; one that cannot be read is not overwritten.
base::Result<void> storeCalibration(const std::string& path, const DeviceCalibration& calibration);

/// The entry of a device, or null.
const DeviceCalibration* findCalibration(const std::vector<DeviceCalibration>& entries, std::string_view device,
                                         std::string_view serial);

}  // namespace tactus::haptics
