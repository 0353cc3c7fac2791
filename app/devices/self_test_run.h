// Runs the self-test on a device: on the servo in real time, or in virtual time where the device is simulated.
#pragma once

#include <string>

#include "app/devices/self_test.h"
#include "core/base/error.h"
#include "core/haptics/device/device.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::devices {

/// The person at the device, as the test meets them.
class SelfTestGuide {
 public:
  virtual ~SelfTestGuide() = default;
  virtual void instruct(const std::string& sentence) = 0;
  virtual void tell(const CheckResult& result) = 0;
  /// May wait as long as it likes: without a sign of life of the program the servo gives no force.
  virtual Felt ask(const std::string& question) = 0;
  /// The program is to end (Ctrl-C). Looked at every few milliseconds; `ask` returns anything then.
  virtual bool interrupted() const noexcept { return false; }
};

/// Starts the device, runs the test on a servo thread, or in the driver's loop, and stops the device. Returns the test
/// as it ended. Refused: the device or the thread does not start; the person interrupts, the device is stopped then.
base::Result<SelfTest> runSelfTest(haptics::HapticDevice& device, const SelfTestSettings& settings,
                                   SelfTestGuide& guide);

/// The same in virtual time with a simulated person, who also answers the question; the guide is told everything and
/// asked nothing. `device` has a live hand.
base::Result<SelfTest> simulateSelfTest(haptics::VirtualDevice& device, const SelfTestSettings& settings,
                                        SelfTestGuide& guide);

/// The one of the two that fits the device.
base::Result<SelfTest> selfTest(haptics::HapticDevice& device, const SelfTestSettings& settings, SelfTestGuide& guide);

/// Settings for a device: its limits, and a shift that is larger than its counts.
SelfTestSettings settingsFor(const haptics::DeviceInfo& info);

}  // namespace tactus::devices
