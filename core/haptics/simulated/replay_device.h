// A recorded stroke as a haptic device. It moves as the recording did and stores the forces written to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/haptics/device/device.h"
#include "core/haptics/simulated/hand_plan.h"
#include "core/haptics/simulated/pausing_clock.h"
#include "core/study/session_records.h"

namespace tactus::haptics {

struct ReplaySettings {
  double lead_s = 0.1;    ///< [0, 100]: rest at the first position, button up; then the button goes down
  bool loop = false;      ///< after the end: back by minimum jerk with the button up, then again
  double return_s = 0.6;  ///< [0.01, 100], duration of the way back
  Vector3 inwards{0, 0, -1};
  std::size_t room_for_forces = 120'000;  ///< two minutes at 1 kHz
};

/// A written force, and the position of the device at that time.
struct CommandedForce {
  std::int64_t time_ns = 0;  ///< on the clock of `write`
  double position_mm = 0;
  Vector3 force_n;

  bool operator==(const CommandedForce&) const = default;
};

/// Channels of the recording: positions from `position`, or else from `depth`; times from `time`, or else from the
/// recording's rate. Between samples the position is linear.
/// The button is down while the recording plays. With a channel `button` (unit 1), it is down from each sample that is
/// not 0 until the next sample.
/// The first `read` after `start` is time 0. A long pause of the clock is skipped as in VirtualDevice.
class ReplayDevice final : public HapticDevice {
 public:
  /// Makes the device. Returns an error for: a missing channel, another unit than mm (time: s, button: 1), fewer than
  /// two samples, channels of different length, values that are not finite, times that rise by less than a nanosecond
  /// or span more than 1e6 s, a rate <= 0, settings out of range.
  static base::Result<std::unique_ptr<ReplayDevice>> make(const study::Recording& recording,
                                                          const ReplaySettings& settings = {});

  const DeviceInfo& info() const noexcept override { return info_; }
  /// Restarts from the beginning and forgets the forces.
  base::Result<void> start() override;
  void stop() noexcept override { running_ = false; }
  DeviceState read(std::int64_t now_ns) noexcept override;
  void write(const Vector3& force_n, std::int64_t now_ns) noexcept override;

  /// Duration from the start to the end of the recording, including the lead, ns.
  std::int64_t lengthNs() const noexcept { return lead_ns_ + time_ns_.back(); }
  /// The forces since `start`; `forcesLost`: how many more did not fit. Thread: the owner, after the servo has ended.
  std::span<const CommandedForce> forces() const noexcept { return forces_; }
  std::uint64_t forcesLost() const noexcept { return forces_lost_; }

 private:
  struct Frame {
    double position_mm = 0;
    bool button = false;
  };
  ReplayDevice(std::vector<std::int64_t> time_ns, std::vector<double> position_mm, std::vector<bool> button,
               const ReplaySettings& settings);
  Frame at(std::int64_t elapsed_ns) const noexcept;

  std::vector<std::int64_t> time_ns_;  ///< from 0, rising
  std::vector<double> position_mm_;
  std::vector<bool> button_;
  ReplaySettings settings_;
  std::int64_t lead_ns_;
  std::int64_t return_ns_;
  HandPlan way_back_;
  DeviceInfo info_;
  bool running_ = false;
  PausingClock clock_;
  DeviceState last_;
  double last_position_mm_ = 0;
  std::vector<CommandedForce> forces_;
  std::uint64_t forces_lost_ = 0;
};

}  // namespace tactus::haptics
