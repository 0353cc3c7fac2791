// The calibration file of a user: measured values of devices, and insertion axes set by hand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/device/device_calibration.h"
#include "core/haptics/device/vector3.h"

namespace tactus::haptics {

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
