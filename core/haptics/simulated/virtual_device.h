// A haptic device without hardware: a simulated mass in a simulated hand, scripted or driven by mouse and keyboard.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/haptics/device/device.h"
#include "core/haptics/simulated/device_simulation.h"
#include "core/haptics/simulated/live_hand.h"
#include "core/haptics/simulated/pausing_clock.h"
#include "core/haptics/simulated/virtual_device_settings.h"

namespace tactus::haptics {

/// The simulation follows the clock that `read` is given: virtual time in tests, the monotonic clock in the workbench.
/// The first `read` after `start` is simulated time 0. Between two reads at most kLongestCatchUpNs are simulated; for
/// the hand the rest of a longer pause did not happen.
class VirtualDevice final : public HapticDevice {
 public:
  /// Refused: what `check` refuses.
  static base::Result<std::unique_ptr<VirtualDevice>> make(VirtualDeviceSettings settings = {});

  const DeviceInfo& info() const noexcept override { return info_; }
  /// Begins anew: time 0, the device at `start_mm`, the same random numbers. A live hand follows its target from there.
  base::Result<void> start() override;
  /// No force, and samples stay what they were.
  void stop() noexcept override;
  DeviceState read(std::int64_t now_ns) noexcept override;
  void write(const Vector3& force_n, std::int64_t now_ns) noexcept override;

  /// Where a live hand wants to be, along the axis; not finite is ignored. Without effect on a scripted hand.
  /// Thread: any. Real-time safe: yes.
  void setTarget(double position_mm) noexcept { live_.setTarget(position_mm); }
  void setButton(bool down) noexcept { live_.setButton(down); }

  /// The truth at the last `read`, neither counted nor delayed nor faulty. Thread: any. Real-time safe: yes.
  double truePositionMm() const noexcept { return true_position_mm_.load(std::memory_order_relaxed); }
  double trueSpeedMmS() const noexcept { return true_speed_mm_s_.load(std::memory_order_relaxed); }
  /// The resistance that acted just before the last `read`: delayed, cut and silenced as the device does it.
  double trueForceN() const noexcept { return true_force_n_.load(std::memory_order_relaxed); }

 private:
  explicit VirtualDevice(VirtualDeviceSettings settings);

  VirtualDeviceSettings settings_;
  DeviceInfo info_;
  LiveHand live_;
  std::optional<DeviceSimulation> simulation_;  ///< since the first `start`
  bool running_ = false;
  PausingClock clock_;
  DeviceState last_;                        ///< times by the clock of `read`
  std::optional<std::int64_t> written_ns_;  ///< simulated time of the force that `last_.written_ns` is about
  std::atomic<double> true_position_mm_{0};
  std::atomic<double> true_speed_mm_s_{0};
  std::atomic<double> true_force_n_{0};
};

}  // namespace tactus::haptics
