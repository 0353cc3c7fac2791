// A haptic device without hardware: a simulated mass in a simulated hand, scripted or moved by mouse and keyboard.
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

/// The simulation follows the clock passed to `read`: virtual time in tests, the monotonic clock in the workbench. The
/// first `read` after `start` is simulated time 0. Between two reads at most kLongestCatchUpNs are simulated; the rest
/// of a longer pause is skipped.
class VirtualDevice final : public HapticDevice {
 public:
  /// Returns the error of `check` if the settings are invalid.
  static base::Result<std::unique_ptr<VirtualDevice>> make(VirtualDeviceSettings settings = {});

  const DeviceInfo& info() const noexcept override { return info_; }
  /// Restarts: time 0, the device at `start_mm`, the same random numbers. A live hand follows its target from there.
  base::Result<void> start() override;
  /// Sets the force to zero. Samples stay unchanged.
  void stop() noexcept override;
  DeviceState read(std::int64_t now_ns) noexcept override;
  void write(const Vector3& force_n, std::int64_t now_ns) noexcept override;

  /// Sets the target of a live hand along the axis. Ignored if not finite. No effect on a scripted hand.
  /// Thread: any. Real-time safe: yes.
  void setTarget(double position_mm) noexcept { live_.setTarget(position_mm); }
  void setButton(bool down) noexcept { live_.setButton(down); }

  /// The true position at the last `read`: not quantized, not delayed, without faults. Thread: any. Real-time safe:
  /// yes.
  double truePositionMm() const noexcept { return true_position_mm_.load(std::memory_order_relaxed); }
  double trueSpeedMmS() const noexcept { return true_speed_mm_s_.load(std::memory_order_relaxed); }
  /// The resistance in effect just before the last `read`: with delay, limit and silence of the device.
  double trueForceN() const noexcept { return true_force_n_.load(std::memory_order_relaxed); }

 private:
  explicit VirtualDevice(VirtualDeviceSettings settings);

  VirtualDeviceSettings settings_;
  DeviceInfo info_;
  LiveHand live_;
  std::optional<DeviceSimulation> simulation_;  ///< since the first `start`
  bool running_ = false;
  PausingClock clock_;
  DeviceState last_;                        ///< times on the clock of `read`
  std::optional<std::int64_t> written_ns_;  ///< simulated time of the force that `last_.written_ns` refers to
  std::atomic<double> true_position_mm_{0};
  std::atomic<double> true_speed_mm_s_{0};
  std::atomic<double> true_force_n_{0};
};

}  // namespace tactus::haptics
