// Runs the guided calibration of a device, or waits for that of its driver.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/haptics/device/calibration_procedure.h"
#include "core/haptics/device/device.h"

namespace tactus::devices {

/// The person at the device.
class CalibrationGuide {
 public:
  virtual ~CalibrationGuide() = default;
  virtual void instruct(const std::string& sentence) = 0;
  /// A sentence about an answer that was refused.
  virtual void refuse(const std::string& sentence) = 0;
  /// The answer to the last instruction, once; nothing: none yet. Must not wait long: the device is pushing.
  /// An answer `stop` ends the procedure.
  virtual std::optional<std::string> answer() = 0;
  /// The program is to end (Ctrl-C). Looked at in every millisecond; then the device is stopped and the run refused.
  virtual bool interrupted() const noexcept { return false; }
};

/// A clock and a way to wait for the next millisecond; both for tests.
struct CalibrationClock {
  std::int64_t (*now_ns)() noexcept;
  void (*sleep_until)(std::int64_t time_ns) noexcept;
};
/// That of the servo.
CalibrationClock systemClock() noexcept;

/// Starts the device, leads through the procedure and stops the device. Refused: the device does not start or gets
/// lost, the procedure fails, the person stops or interrupts it. `measured_at`: UTC.
base::Result<haptics::DeviceCalibration> runCalibration(haptics::HapticDevice& device,
                                                        const haptics::CalibrationPlan& plan,
                                                        const std::string& measured_at, CalibrationGuide& guide,
                                                        const CalibrationClock& clock = systemClock());

/// For a device that its own driver calibrates (OpenHaptics): tells the person what to do and waits until the driver
/// says that it is calibrated; an answer tells the driver that the device is in its reference posture. Refused: a
/// device of another kind, one that does not start, a person who stops or
/// interrupts.
base::Result<void> calibrateByDriver(haptics::HapticDevice& device, CalibrationGuide& guide,
                                     const CalibrationClock& clock = systemClock());

}  // namespace tactus::devices
