// Devices and feeling in virtual time: the servo ticks when a test says so, on a virtual device.
#pragma once

#include <QString>
#include <atomic>
#include <cstdint>

#include "app/workbench/device/device_session.h"
#include "app/workbench/device/virtual_time.h"
#include "app/workbench/feel/feel_controller.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::tests {

/// Outlives the session that has its settings.
class SteppedFeel {
 public:
  explicit SteppedFeel(haptics::VirtualDeviceSettings device = {}) : device_(std::move(device)) {}

  workbench::DeviceAccess settings();
  /// The same with a device that starts and stops in the background, and does either only while `lets_go` is true.
  workbench::DeviceAccess slowSettings(const std::atomic<bool>& lets_go);

  /// Ticks once per millisecond; `session` gets a beat every 16 ms and one at the end.
  void advance(workbench::DeviceSession& session, int milliseconds) { time_.advance(session, milliseconds); }
  /// Ticks without a beat: the program stands still.
  void hang(int milliseconds) { time_.hang(milliseconds); }
  /// Time goes on and `session` gets its beats, but nothing calls the servo.
  void stall(workbench::DeviceSession& session, int milliseconds);
  /// Time goes on while nothing is felt.
  void pass(int milliseconds) { time_.pass(milliseconds); }
  /// The wish of the hand goes to `position_mm` with `speed_mm_s`, and rests there for 0.1 s.
  void moveTo(workbench::DeviceSession& session, double position_mm, double speed_mm_s);

  /// The same for the device on which a model is felt.
  void advance(workbench::FeelController& feel, int milliseconds) { advance(feel.session(), milliseconds); }
  void stall(workbench::FeelController& feel, int milliseconds) { stall(feel.session(), milliseconds); }
  void moveTo(workbench::FeelController& feel, double position_mm, double speed_mm_s) {
    moveTo(feel.session(), position_mm, speed_mm_s);
  }

  /// The virtual time of all devices.
  std::int64_t nowNs() const { return time_.nowNs(); }
  /// Ticks of all loops so far.
  std::uint64_t ticks() const { return time_.ticks(); }
  /// Loops that are there now.
  int loops() const { return time_.hasLoop() ? 1 : 0; }

 private:
  haptics::VirtualDeviceSettings device_;
  workbench::VirtualTime time_;
};

}  // namespace tactus::tests
