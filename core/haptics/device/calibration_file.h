// The file of a person that keeps what was measured on devices, and the insertion axes that were set by hand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/device/device_calibration.h"
#include "core/haptics/device/vector3.h"

namespace tactus::haptics {

/// The way the tube goes on a device that its own driver calibrates.
struct DeviceAxis {
  std::string device;         ///< DeviceInfo::id
  std::string serial;         ///< DeviceInfo::serial; may be empty
  Vector3 inwards{0, 0, -1};  ///< unit length

  bool operator==(const DeviceAxis&) const = default;
};

/// Each device and serial number at most once in each list.
struct CalibrationFile {
  std::vector<DeviceCalibration> calibrations;
  std::vector<DeviceAxis> axes;
};

/// The entries of the JSON file `path`; none where there is no file. Refused, with the place: what is not of this
/// format, an unknown, missing or doubled key, nonsense numbers, two entries of one device, a file above 1 MiB.
base::Result<CalibrationFile> readCalibrationFile(const std::string& path);

/// Puts `calibration` into the file, in the place of an older entry of the same device and serial number. The file
/// appears whole or stays as it was; one that cannot be read is not overwritten.
base::Result<void> storeCalibration(const std::string& path, const DeviceCalibration& calibration);

/// The same for an axis. Refused: a direction that is not of length 1.
base::Result<void> storeAxis(const std::string& path, const DeviceAxis& axis);

/// The entry of a device, or null.
const DeviceCalibration* findCalibration(const std::vector<DeviceCalibration>& entries, std::string_view device,
                                         std::string_view serial);
const DeviceAxis* findAxis(const std::vector<DeviceAxis>& entries, std::string_view device, std::string_view serial);

}  // namespace tactus::haptics
