// A device while it is felt: open, started, and under the servo.
#pragma once

#include <QString>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "app/devices/open_device.h"
#include "app/workbench/feel/feel_loop.h"
#include "core/base/error.h"
#include "core/haptics/servo/servo.h"

namespace tactus::haptics {
class VirtualDevice;
}

namespace tactus::workbench {

/// Runs from `begin` to the destructor, which leaves the device without force. Thread: one at a time; a device that
/// takes its time is begun and ended by another one than the gui's.
class FeelRun {
 public:
  /// Starts the device and hands `orders` to a servo on it, with the axis of the device and the limits that fit it.
  /// The first sign of life is given. Refused: the device or the loop does not start.
  /// `thermal`, where there is one, knows what the motors of the device have given in the runs before.
  static base::Result<std::unique_ptr<FeelRun>> begin(devices::OpenedDevice opened, const MakeFeelLoop& make_loop,
                                                      haptics::ServoOrders orders,
                                                      std::shared_ptr<haptics::ThermalLedger> thermal = nullptr);
  ~FeelRun();
  FeelRun(const FeelRun&) = delete;
  FeelRun& operator=(const FeelRun&) = delete;

  haptics::Servo& servo() { return *servo_; }
  const haptics::DeviceInfo& info() const { return device_->info(); }
  const FeelLoop& loop() const { return *loop_; }
  /// The orders that were posted last; changed and posted again by the owner.
  haptics::ServoOrders& orders() { return orders_; }
  /// Posts the orders; returns their number.
  std::uint64_t post();
  void heartbeat() { servo_->heartbeat(loop_->nowNs()); }
  /// The samples since the last call, oldest first; valid until the next one.
  std::span<const haptics::Sample> drain();
  /// The device where its hand is driven by mouse and keyboard, else null.
  haptics::VirtualDevice* liveHand() const { return live_hand_; }
  /// What to do when the device says that it is not calibrated.
  const std::string& calibrationAdvice() const { return calibration_advice_; }
  /// What to do when inwards is outwards; may be empty.
  const std::string& axisAdvice() const { return axis_advice_; }
  /// Zero force from the next tick on, then no tick any more. May be called twice.
  void end() noexcept;

 private:
  FeelRun(devices::OpenedDevice opened, const MakeFeelLoop& make_loop, haptics::ServoOrders orders,
          std::shared_ptr<haptics::ThermalLedger> thermal);

  // In this order, so that the loop ends before the servo, and the servo before the device.
  std::shared_ptr<haptics::ThermalLedger> thermal_;
  std::unique_ptr<haptics::HapticDevice> device_;
  haptics::VirtualDevice* live_hand_;
  std::string calibration_advice_;
  std::string axis_advice_;
  haptics::ServoOrders orders_;
  std::unique_ptr<haptics::Servo> servo_;
  std::unique_ptr<FeelLoop> loop_;
  std::vector<haptics::Sample> drained_;
};

}  // namespace tactus::workbench
