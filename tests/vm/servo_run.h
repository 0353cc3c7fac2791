// The whole chain on one HID device: transport, device, servo and its thread, pulling with a constant force.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/haptics/device/calibration_file.h"
#include "core/haptics/hid/hid_pid_device.h"
#include "core/haptics/servo/servo.h"

namespace tactus::vm {

/// Opens without starting.
base::Result<std::unique_ptr<haptics::HidPidDevice>> openDevice(
    const haptics::HidDevice& listed, const std::optional<haptics::DeviceCalibration>& calibration);

class ServoRun {
 public:
  /// Starts device and servo.
  static base::Result<std::unique_ptr<ServoRun>> begin(const haptics::HidDevice& listed,
                                                       const haptics::DeviceCalibration& calibration);
  ~ServoRun();

  /// Armed, and pulls as soon as the first button of the device is down.
  void pull(double resistance_n);

  /// Lets `seconds` pass and returns the samples of that time.
  std::vector<haptics::Sample> pass(double seconds);

  haptics::LoopStatistics statistics() const { return servo_->statistics(); }
  haptics::HidPidCounters counters() const { return device_->counters(); }
  const haptics::ServoThreadState& state() const { return thread_->state(); }

 private:
  ServoRun(std::unique_ptr<haptics::HidPidDevice> device, const haptics::DeviceCalibration& calibration);

  std::unique_ptr<haptics::HidPidDevice> device_;
  haptics::DeviceCalibration calibration_;
  std::unique_ptr<haptics::Servo> servo_;
  std::unique_ptr<haptics::ServoThread> thread_;
};

}  // namespace tactus::vm
