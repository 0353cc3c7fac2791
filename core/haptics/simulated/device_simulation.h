// A haptic device with a hand on it, in simulated time. VirtualDevice runs it by the clock of the servo.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/random.h"
#include "core/haptics/device/device.h"
#include "core/haptics/simulated/force_queue.h"
#include "core/haptics/simulated/simulated_body.h"
#include "core/haptics/simulated/virtual_device_settings.h"

namespace tactus::haptics {

/// Copyable. The same settings and calls give the same bits. Times are ns since the start of the simulation. The hand's
/// plan, dropped samples, stalls and faults change once per millisecond. Forces arrive between any two steps. Thread:
/// any, one at a time. Real-time safe: all but the constructor.
class DeviceSimulation {
 public:
  /// `settings`: must pass `check` and contain a plan.
  explicit DeviceSimulation(VirtualDeviceSettings settings);

  /// Advances in whole steps up to `until_ns`; less than one step is missing.
  void advance(std::int64_t until_ns) noexcept;

  /// Writes a force along the insertion axis at `at_ns`, positive against insertion. It acts after the delay.
  void push(double resistance_n, std::int64_t at_ns) noexcept;

  /// The newest sample. If a sample was dropped or stalled, the previous one remains.
  DeviceState sample() noexcept;

  const SimulatedBody& body() const noexcept { return body_; }
  /// The resistance in effect during the last step.
  double forceInEffectN() const noexcept { return force_n_; }
  /// The time at which the newest force reached the device; empty if none did.
  std::optional<std::int64_t> writtenNs() const noexcept { return written_ns_; }

 private:
  bool has(InjectedFault fault) const noexcept { return ((faults_ >> static_cast<int>(fault)) & 1U) != 0; }
  void beginMillisecond() noexcept;
  double arrivingForce() noexcept;

  VirtualDeviceSettings settings_;
  std::int64_t step_ns_;
  double step_s_;
  std::int64_t delay_ns_;
  std::int64_t quiet_after_ns_;

  SimulatedBody body_;
  base::Random random_;
  ForceQueue on_the_way_;
  HandWish wish_;
  std::int64_t time_ns_ = 0;
  std::int64_t millisecond_ = 0;    ///< the next one to start
  std::int64_t stalled_until_ = 0;  ///< a millisecond
  std::uint32_t faults_ = 0;        ///< InjectedFault as bits
  bool dropped_ = false;            ///< samples of this millisecond do not arrive
  double told_n_ = 0;               ///< the newest force that has reached the device
  std::optional<std::int64_t> written_ns_;
  DeviceFault force_fault_ = DeviceFault::kNone;
  double force_n_ = 0;
  DeviceState sample_;
};

}  // namespace tactus::haptics
