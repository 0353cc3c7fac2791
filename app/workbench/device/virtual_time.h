// The servo in virtual time: it ticks when its owner says so, as fast as the computer can. For rehearsals and tests.
#pragma once

#include <cstdint>
#include <memory>

#include "app/workbench/device/device_search.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::workbench {

class DeviceSession;

/// One clock for a device session and for all who measure time beside it. Thread: one.
class VirtualTime {
 public:
  static constexpr int kBeat = 16;  ///< ms between two beats of a session: the refresh of a screen

  /// The loop of every servo ticks in this time, which outlives it.
  MakeServoLoop loops();
  /// A virtual device in this time, whatever the id of the device.
  DeviceAccess access(haptics::VirtualDeviceSettings device = {});

  /// One millisecond after another, each with a tick; `session` gets a beat every 16 ms and one at the end.
  void advance(DeviceSession& session, int milliseconds);
  /// The same without a beat: the program stands still.
  void hang(int milliseconds);
  /// Time passes without a tick.
  void pass(int milliseconds) { now_ns_ += std::int64_t{1'000'000} * milliseconds; }

  std::int64_t nowNs() const { return now_ns_; }
  /// Ticks of all loops so far.
  std::uint64_t ticks() const { return ticks_; }
  /// Whether there is a loop now.
  bool hasLoop() const { return loop_ != nullptr; }

 private:
  class Loop;

  Loop* loop_ = nullptr;  ///< of the present run
  std::int64_t now_ns_ = 1'000'000'000;
  std::uint64_t ticks_ = 0;
};

}  // namespace tactus::workbench
