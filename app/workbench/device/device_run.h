// One run of a device: open, started, and driven by the servo.
#pragma once

#include <QString>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "app/devices/device_list.h"
#include "app/workbench/device/servo_loop.h"
#include "core/base/error.h"
#include "core/haptics/servo/servo.h"

namespace tactus::haptics {
class VirtualDevice;
}

namespace tactus::workbench {

/// The run lasts from `begin` to the destructor, which leaves the device with zero force. Thread: one at a time. A slow
/// device begins and ends on a background thread.
class DeviceRun {
 public:
  /// Starts the device, and a servo on it with `orders`, the axis of the device and limits that fit it. Sends the first
  /// heartbeat of the program. `thermal` may be null; otherwise it holds the motor heat of earlier runs. Refused: the
  /// device or the loop does not start.
  static base::Result<std::unique_ptr<DeviceRun>> begin(devices::OpenedDevice opened, const MakeServoLoop& make_loop,
                                                        haptics::ServoOrders orders,
                                                        std::shared_ptr<haptics::ThermalLedger> thermal = nullptr);
  ~DeviceRun();
  DeviceRun(const DeviceRun&) = delete;
  DeviceRun& operator=(const DeviceRun&) = delete;

  haptics::Servo& servo() { return *servo_; }
  const haptics::DeviceInfo& info() const { return device_->info(); }
  const ServoLoop& loop() const { return *loop_; }
  /// The last posted orders. The owner changes them and posts them again.
  haptics::ServoOrders& orders() { return orders_; }
  /// Posts the orders; returns their number.
  std::uint64_t post();
  void heartbeat() { servo_->heartbeat(loop_->nowNs()); }
  /// The samples since the last call, oldest first. Valid until the next call.
  std::span<const haptics::Sample> drain();
  /// The device if mouse and keyboard drive its hand; otherwise null.
  haptics::VirtualDevice* liveHand() const { return live_hand_; }
  /// What to do if the device reports that it is not calibrated.
  const std::string& calibrationAdvice() const { return calibration_advice_; }
  /// What to do if inward and outward are swapped; may be empty.
  const std::string& axisAdvice() const { return axis_advice_; }
  /// Zero force from the next tick on; then no more ticks. May be called twice.
  void end() noexcept;

 private:
  DeviceRun(devices::OpenedDevice opened, const MakeServoLoop& make_loop, haptics::ServoOrders orders,
            std::shared_ptr<haptics::ThermalLedger> thermal);

  // In this order, so that the loop is destroyed before the servo, and the servo before the device.
  std::shared_ptr<haptics::ThermalLedger> thermal_;
  std::unique_ptr<haptics::HapticDevice> device_;
  haptics::VirtualDevice* live_hand_;
  std::string calibration_advice_;
  std::string axis_advice_;
  haptics::ServoOrders orders_;
  std::unique_ptr<haptics::Servo> servo_;
  std::unique_ptr<ServoLoop> loop_;
  std::vector<haptics::Sample> drained_;
};

}  // namespace tactus::workbench
