// A recorded stroke as a haptic device: it moves as the recording did, and keeps the forces that it is told.
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
  double lead_s = 0.1;    ///< [0, 100]: rests at the first position, button up; then the button goes down
  bool loop = false;      ///< after the end, button up: back by minimum jerk, and once more
  double return_s = 0.6;  ///< [0.01, 100], the way back of a loop
  Vector3 inwards{0, 0, -1};
  std::size_t room_for_forces = 120'000;  ///< two minutes at 1 kHz
};

/// A force that the device was told, and where it was.
struct ToldForce {
  std::int64_t time_ns = 0;  ///< by the clock of `write`
  double position_mm = 0;
  Vector3 force_n;

  bool operator==(const ToldForce&) const = default;
};

/// Positions are those of channel `position`, or `depth` where there is none, at the times of channel `time`, or at
/// the recording's rate where there is none; in between they lie on straight lines. The button is down while the
/// recording plays; with a channel `button` (unit 1), at the samples where that is not 0, each until the next one. The
/// first `read` after `start` is time 0; a long pause of the clock is left out as in VirtualDevice.
class ReplayDevice final : public HapticDevice {
 public:
  /// Refused: no such channel or another unit than mm (time: s, button: 1), fewer than two samples, channels of
  /// different length, values that are not finite, times that do not rise by a nanosecond at least or span more than
  /// 1e6 s, a rate that is not above 0, settings out of range.
  static base::Result<std::unique_ptr<ReplayDevice>> make(const study::Recording& recording,
                                                          const ReplaySettings& settings = {});

  const DeviceInfo& info() const noexcept override { return info_; }
  /// Begins anew and forgets the forces.
  base::Result<void> start() override;
  void stop() noexcept override { running_ = false; }
  DeviceState read(std::int64_t now_ns) noexcept override;
  void write(const Vector3& force_n, std::int64_t now_ns) noexcept override;

  /// From the start to the end of the recording, lead included, ns.
  std::int64_t lengthNs() const noexcept { return lead_ns_ + time_ns_.back(); }
  /// Those since `start`, and how many more there were than there is room for. Thread: the owner, after the servo.
  std::span<const ToldForce> forces() const noexcept { return forces_; }
  std::uint64_t forcesLost() const noexcept { return forces_lost_; }

 private:
  struct Moment {
    double position_mm = 0;
    bool button = false;
  };
  ReplayDevice(std::vector<std::int64_t> time_ns, std::vector<double> position_mm, std::vector<bool> button,
               const ReplaySettings& settings);
  Moment at(std::int64_t elapsed_ns) const noexcept;

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
  std::vector<ToldForce> forces_;
  std::uint64_t forces_lost_ = 0;
};

}  // namespace tactus::haptics
