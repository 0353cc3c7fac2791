// Runs the guided self-test and the guided calibration of a device.
#pragma once

#include <optional>
#include <string>

#include "app/devices/self_test.h"
#include "core/base/error.h"
#include "core/haptics/device/calibration_procedure.h"
#include "core/haptics/device/device.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::devices {

// Runs the guided calibration of a device, or waits for the calibration by its driver.

/// The person at the device.
class CalibrationGuide {
 public:
  virtual ~CalibrationGuide() = default;
  virtual void instruct(const std::string& sentence) = 0;
  /// Shows a sentence about a refused answer.
  virtual void refuse(const std::string& sentence) = 0;
  /// The answer to the last instruction, returned once; nothing: no answer yet. Must return quickly, because the device
  /// is pushing. The answer `stop` ends the procedure.
  virtual std::optional<std::string> answer() = 0;
  /// Whether the program must end (Ctrl-C). Checked in every millisecond. If true, the device is stopped and the run
  /// refused.
  virtual bool interrupted() const noexcept { return false; }
};

/// A clock, and a wait for the next millisecond. Tests replace both.
struct CalibrationClock {
  std::int64_t (*now_ns)() noexcept;
  void (*sleep_until)(std::int64_t time_ns) noexcept;
};
/// The clock of the servo.
CalibrationClock systemClock() noexcept;

/// Starts the device, guides the person through the procedure and stops the device. Refused: the device does not start
/// or disconnects, the procedure fails, the person stops or interrupts it. `measured_at`: UTC.
base::Result<haptics::DeviceCalibration> runCalibration(haptics::HapticDevice& device,
                                                        const haptics::CalibrationPlan& plan,
                                                        const std::string& measured_at, CalibrationGuide& guide,
                                                        const CalibrationClock& clock = systemClock());

/// For a device that its own driver calibrates (OpenHaptics): instructs the person and waits until the driver reports
/// the calibration. An answer tells the driver that the device is in its reference posture. Refused: a device of
/// another kind, a device that does not start, a person who stops or interrupts.
base::Result<void> calibrateByDriver(haptics::HapticDevice& device, CalibrationGuide& guide,
                                     const CalibrationClock& clock = systemClock());

// Runs the self-test on a device: on the servo in real time, or in virtual time for a simulated device.

/// The person at the device.
class SelfTestGuide {
 public:
  virtual ~SelfTestGuide() = default;
  virtual void instruct(const std::string& sentence) = 0;
  virtual void tell(const CheckResult& result) = 0;
  /// Asks the question; may wait without limit. Meanwhile the program sends no heartbeat, so the servo gives no force.
  virtual Felt ask(const std::string& question) = 0;
  /// Whether the program must end (Ctrl-C). Checked every few milliseconds; the value of `ask` is then ignored.
  virtual bool interrupted() const noexcept { return false; }
};

/// Starts the device, runs the test on a servo thread (or in the driver's loop) and stops the device. Returns the
/// finished test. Refused: the device or the thread does not start; the person interrupts (the device is then stopped).
base::Result<SelfTest> runSelfTest(haptics::HapticDevice& device, const SelfTestSettings& settings,
                                   SelfTestGuide& guide);

/// The same in virtual time. A simulated person also answers the question; the guide gets all messages but no
/// questions. `device` must have a live hand.
base::Result<SelfTest> simulateSelfTest(haptics::VirtualDevice& device, const SelfTestSettings& settings,
                                        SelfTestGuide& guide);

/// Calls the function of the two that fits the device.
base::Result<SelfTest> selfTest(haptics::HapticDevice& device, const SelfTestSettings& settings, SelfTestGuide& guide);

/// The settings for a device: its limits, and a shift larger than its counts.
SelfTestSettings settingsFor(const haptics::DeviceInfo& info);

}  // namespace tactus::devices
