// The calibration file of a user: measured values of devices, and insertion axes set by hand.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/device/device.h"

namespace tactus::haptics {

// The calibration of one device: force at full scale, signs, friction, mm per count, insertion axis.

/// One entry per device and serial number. Vectors are in the device's frame (device.h).
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

/// The insertion direction of a device whose own driver calibrates it.
struct DeviceAxis {
  std::string device;         ///< DeviceInfo::id
  std::string serial;         ///< DeviceInfo::serial; may be empty
  Vector3 inwards{0, 0, -1};  ///< unit length

  bool operator==(const DeviceAxis&) const = default;
};

/// The entries of the file. Each list has at most one entry per device and serial number.
struct CalibrationFile {
  std::vector<DeviceCalibration> calibrations;
  std::vector<DeviceAxis> axes;
};

/// Reads the JSON file `path`. No entries if the file does not exist. Returns an error with its place for another
/// format, an unknown, missing or duplicate key, numbers out of range, two entries of one device, or a file above 1
/// MiB.
base::Result<CalibrationFile> readCalibrationFile(const std::string& path);

/// Stores `calibration` in the file and replaces an older entry of the same device and serial number. If writing fails,
/// the old file stays. An unreadable file is not overwritten; the function returns the read error.
base::Result<void> storeCalibration(const std::string& path, const DeviceCalibration& calibration);

/// The same for an axis. Returns an error if the direction does not have the length 1.
base::Result<void> storeAxis(const std::string& path, const DeviceAxis& axis);

/// The entry of a device, or null.
const DeviceCalibration* findCalibration(const std::vector<DeviceCalibration>& entries, std::string_view device,
                                         std::string_view serial);
const DeviceAxis* findAxis(const std::vector<DeviceAxis>& entries, std::string_view device, std::string_view serial);

}  // namespace tactus::haptics
