// Runs the self-test on a device: on the servo in real time, or in virtual time for a simulated device.
#pragma once

#include <string>

#include "app/devices/self_test.h"
#include "core/base/error.h"
#include "core/haptics/device/device.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::devices {

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
